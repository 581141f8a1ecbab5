#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "cutting_report.hpp"
#include "mesh/quality.hpp"
#include "project_choice.hpp"
#include "text/chosen_bodies.hpp"
#include "text/json_text.hpp"
#include "text/table.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Null where it is not rated.
Json quality_of(const Block& block) {
  if (block.stands_on_corners) return nullptr;
  const MeshQuality quality = mesh_quality(block.mesh);
  return {{"worst", quality.worst}, {"mean", quality.mean}};
}

std::string quality_text(const Json& quality, const char* figure) {
  return quality.is_null() ? "–" : number(quality[figure], 3);
}

Json json_of(const Project& project, const BlockSystem& system) {
  Json blocks = Json::array();
  double volume = 0;
  for (const Block& block : system.blocks) {
    volume += block.volume;
    Json json = {{"name", block.name}, {"volume", block.volume}, {"body", to_string(block.body)}};
    if (!block.body_reason.empty()) json["body_reason"] = block.body_reason;
    json.update({{"nodes", block.mesh.nodes.size()},
                 {"tetrahedra", block.mesh.tetrahedra.size()},
                 {"quality", quality_of(block)}});
    blocks.push_back(json);
  }
  Json json = {{"blocks", blocks}, {"volume", volume}, {"solids_volume", system.solids_volume}};
  json.update(cutting_report_json(project, system));
  return json;
}

void print(const Json& mesh, const Project& project, const BlockSystem& system) {
  Table table({"Block", "Volume [m³]", "Body", "Nodes", "Tetrahedra", "Worst quality", "Mean quality"}, "lrlrrrr");
  std::size_t nodes = 0, tetrahedra = 0;
  for (const Json& block : mesh["blocks"]) {
    nodes += block["nodes"].get<std::size_t>();
    tetrahedra += block["tetrahedra"].get<std::size_t>();
    table.add({block["name"], number(block["volume"], 8), block["body"], block["nodes"].dump(),
               block["tetrahedra"].dump(), quality_text(block["quality"], "worst"),
               quality_text(block["quality"], "mean")});
  }
  table.add({"total", number(mesh["volume"], 8), "", std::to_string(nodes), std::to_string(tetrahedra), "", ""});
  std::cout << table.text()
            << "Quality: 3 × inscribed / circumscribed radius; 1 is regular, 0 flat; – where a block stands on its "
               "corners,\nand moves as a whole.\n"
            << chosen_bodies_text(system) << cutting_report_text(project, system);
}

ExitCode mesh(const ProjectChoice& choice, bool json) {
  const Project project = read(choice);
  catch_interrupts();
  const BlockSystem system = build(project, choice);
  const Json result = json_of(project, system);
  if (json)
    std::cout << json_text(result) << '\n';
  else
    print(result, project, system);
  return done;
}

}  // namespace

void add_mesh(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("mesh", "Cut and mesh a project; print a table of its blocks");
  auto choice = std::make_shared<ProjectChoice>();
  add_project(*command, *choice);
  command->callback(
      [&invocation, choice] { invocation.run = [&invocation, choice] { return mesh(*choice, invocation.json); }; });
}

}  // namespace talus::cli
