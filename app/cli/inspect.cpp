#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "geometry/solid_surface.hpp"
#include "project_choice.hpp"
#include "text/json_text.hpp"
#include "text/table.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

Json json_of(const SolidSurface& surface) {
  Json findings = Json::array();
  for (const SurfaceFinding& finding : surface.findings)
    findings.push_back({{"finding", name_of(finding.kind, true)},
                        {"count", finding.count},
                        {"where", json_of(finding.where)},
                        {"mended", finding.mended},
                        {"remedy", remedy_of(finding.kind, finding.mended)}});
  return {{"name", surface.name},
          {"volume", surface.volume},
          {"min", json_of(surface.min)},
          {"max", json_of(surface.max)},
          {"triangles", surface.triangles.size()},
          {"closed", surface.closed},
          {"part", surface.is_part},
          {"findings", findings}};
}

void print(const std::vector<SolidSurface>& surfaces) {
  Table table({"Solid", "Volume [m³]", "x [m]", "y [m]", "z [m]", "Triangles", "Closed"}, "lrrrrrl");
  for (const SolidSurface& surface : surfaces) {
    const double rounding = 1e-12 * (surface.max - surface.min).norm();
    const auto bound = [&](double value) { return number(std::abs(value) < rounding ? 0 : value, 6); };
    const auto extent = [&](int axis) { return bound(surface.min[axis]) + " … " + bound(surface.max[axis]); };
    table.add({surface.name + (surface.is_part ? " *" : ""), surface.closed ? number(surface.volume, 6) : "-",
               extent(0), extent(1), extent(2), std::to_string(surface.triangles.size()),
               surface.closed ? "yes" : "no"});
  }
  std::cout << table.text();
  for (const SolidSurface& surface : surfaces)
    for (const SurfaceFinding& finding : surface.findings)
      std::cout << surface.name << ": " << text_of(finding) << ", at (" << number(finding.where.x(), 6) << ", "
                << number(finding.where.y(), 6) << ", " << number(finding.where.z(), 6) << ")\n";
  if (std::any_of(surfaces.begin(), surfaces.end(), [](const auto& surface) { return surface.is_part; }))
    std::cout << "* a part of a combined solid, no body of its own.\n";
}

/// Whether rock can be made of all of them.
bool are_sound(const std::vector<SolidSurface>& surfaces) {
  for (const SolidSurface& surface : surfaces)
    if (std::any_of(surface.findings.begin(), surface.findings.end(), is_fatal)) return false;
  return true;
}

ExitCode inspect(ProjectChoice choice, bool json) {
  choice.reading.unfinished = true;  // solids are looked at before the rest of a project is there
  const Project project = read(choice);
  catch_interrupts();
  const std::vector<SolidSurface> surfaces = about(choice.name(), [&] {
    TerminalProgress progress;
    return solid_surfaces(project, choice.folder(), progress);
  });
  Json solids = Json::array();
  for (const SolidSurface& surface : surfaces) solids.push_back(json_of(surface));
  if (json)
    std::cout << json_text({{"solids", solids}}) << '\n';
  else
    print(surfaces);
  return are_sound(surfaces) ? done : failed;
}

}  // namespace

void add_inspect(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand(
      "inspect", "Read the solids of a project before they are cut; print what is wrong with their surfaces");
  auto choice = std::make_shared<ProjectChoice>();
  add_project(*command, *choice);
  command->callback(
      [&invocation, choice] { invocation.run = [&invocation, choice] { return inspect(*choice, invocation.json); }; });
}

}  // namespace talus::cli
