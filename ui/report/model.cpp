#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "model/number_text.hpp"
#include "orientation/project_joints.hpp"
#include "render/paint/numbers.hpp"
#include "render/stereonet/stereonet_picture.hpp"
#include "report/contact_planes.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

constexpr std::size_t most_blocks = 20, most_cuts = 40;
constexpr int most_poles = 2000;  ///< of a cut that is drawn by chance

/// "1 fixed, 4 rigid".
std::string bodies_text(const BlockSystem& system) {
  std::map<BodyKind, long> counts;
  for (const Block& block : system.blocks) ++counts[block.body];
  std::string text;
  for (const auto& [kind, count] : counts)
    text += (text.empty() ? "" : ", ") + count_text(count) + " " +
            (kind == BodyKind::tetrahedra ? "deformable (tetrahedra)" : std::string(to_string(kind)));
  return text;
}

Facts blocks_in_sum(const RunRecord& run) {
  double volume = 0, movable = 0;
  std::size_t nodes = 0, tetrahedra = 0;
  for (const Block& block : run.system().blocks) {
    volume += block.volume;
    if (block.body != BodyKind::fixed) movable += block.volume;
    nodes += block.mesh.nodes.size();
    tetrahedra += block.mesh.tetrahedra.size();
  }
  Facts facts;
  facts.rows = {
      {"Blocks", count_text(static_cast<long>(run.system().blocks.size())) + ": " + bodies_text(run.system())},
      {"Volume", format_number(volume, 4) + " m³, of it " + format_number(movable, 4) + " m³ in blocks that may move"},
      {"Mesh", counted_text(static_cast<long>(nodes), "node", "nodes") + ", " +
                   counted_text(static_cast<long>(tetrahedra), "tetrahedron", "tetrahedra")}};
  if (run.project) {
    facts.rows.push_back({"Gravity", given(run.project->gravity) + " m/s²  (x east, y north, z up)"});
    if (!run.project->origin.isZero()) facts.rows.push_back({"Local origin", given(run.project->origin) + " m"});
  }
  return facts;
}

Table materials(const Project& project) {
  Table table{"Materials",
              {"Material", "Density (kg/m³)", "Young’s modulus (GPa)", "Poisson’s ratio", "Damping (1/s)", "Law"},
              "lrrrrl",
              {}};
  for (const Material& material : project.materials)
    table.rows.push_back({material.name, given(material.density), given(material.young / 1e9), given(material.poisson),
                          given(material.damping), std::string(to_string(material.law))});
  return table;
}

/// Of the materials that have a strength.
Table rock_strengths(const Project& project) {
  Table table{"Materials: strength after Mohr and Coulomb",
              {"Material", "Friction angle (°)", "Cohesion (MPa)", "Tensile strength (MPa)"},
              "lrrr",
              {}};
  for (const Material& material : project.materials)
    if (const auto& strength = material.strength)
      table.rows.push_back(
          {material.name, given(strength->friction_angle), given(strength->cohesion / 1e6),
           strength->tensile_strength ? given(*strength->tensile_strength / 1e6) : "to the envelope’s apex"});
  return table;
}

Table joint_strengths(const Project& project) {
  Table table{
      "Joints: strength",
      {"Joint", "Friction angle (°)", "Residual (°)", "Cohesion (kPa)", "Tensile strength (kPa)", "Restitution"},
      "lrrrrr",
      {}};
  const auto or_dash = [](const std::optional<double>& value) { return value ? given(*value) : "–"; };
  for (const Joint& joint : project.joints)
    table.rows.push_back({joint.name, given(joint.friction_angle), or_dash(joint.residual_friction_angle),
                          given(joint.cohesion / 1e3), given(joint.tensile_strength / 1e3),
                          or_dash(joint.restitution)});
  return table;
}

/// What a cut is beside one plane without end.
std::string extent_text(const Cut& cut) {
  std::string text;
  if (cut.network)
    text = "network of discs, P32 " + given(cut.network->density) + " m²/m³, mean radius " +
           quantity(cut.network->radius, "m");
  else if (cut.disc)
    text = "disc of radius " + quantity(cut.disc->radius, "m");
  else if (!cut.polygon.empty())
    text = "polygon of " + std::to_string(cut.polygon.size()) + " corners";
  else
    text = cut.count.value_or(1) > 1 ? "planes without end" : "plane without end";
  for (std::size_t i = 0; i < cut.ends_at.size(); ++i) text += (i == 0 ? ", ends at " : ", ") + cut.ends_at[i];
  if (cut.fisher_kappa) text += ", scattered by κ " + given(*cut.fisher_kappa);
  return text;
}

/// "35.5° / 120°"
std::string dip_text(const PlaneAttitude& plane) {
  const auto degrees_text = [](double value) { return given(std::round(10 * value) / 10) + "°"; };
  return degrees_text(plane.dip) + " / " + degrees_text(plane.dip_direction);
}

Table attitudes(const Project& project) {
  Table table{"Joints: attitude",
              {"Joint", "Dip / dip direction", "Planes", "Spacing (m)", "Through (m)", "Extent"},
              "llrrll",
              {}};
  for (const Cut& cut : project.cuts) {
    if (table.rows.size() == most_cuts) break;
    table.rows.push_back(
        {cut.joint, dip_text({cut.dip, cut.dip_direction}), cut.network ? "–" : std::to_string(cut.count.value_or(1)),
         cut.spacing && cut.count.value_or(1) > 1 ? given(*cut.spacing) : "–", given(cut.through), extent_text(cut)});
  }
  return table;
}

Chart net_of(std::vector<MeasuredJoint> joints) {
  Stereonet net;
  net.joints = std::move(joints);
  net.paper = paper;
  return {stereonet_painting(net, "Poles of the joints"), 700, 400,
          "Lower hemisphere, equal area; poles, and great circles of the sets’ means."};
}

Table interfaces(const Project& project) {
  Table table{"Joints of single pairs of blocks", {"Between", "and", "Joint"}, "lll", {}};
  for (const Interface& interface : project.interfaces) {
    if (table.rows.size() == most_cuts) break;
    table.rows.push_back({interface.between[0], interface.between[1], interface.joint});
  }
  return table;
}

Paragraph more(std::size_t count, const char* one, const char* many) {
  return {"… and " + counted_text(static_cast<long>(count), one, many) + ".", Paragraph::Kind::note};
}

void add_cuts(const Project& project, Section& section) {
  section.parts.emplace_back(attitudes(project));
  if (project.cuts.size() > most_cuts)
    section.parts.emplace_back(more(project.cuts.size() - most_cuts, "more cut", "more cuts"));
  section.parts.emplace_back(net_of(joints_of(project, most_poles).joints));
  if (project.interfaces.empty()) return;
  section.parts.emplace_back(interfaces(project));
  if (project.interfaces.size() > most_cuts)
    section.parts.emplace_back(more(project.interfaces.size() - most_cuts, "more pair", "more pairs"));
}

/// Of blocks that no cut has made: the planes in which they lie against each other.
void add_contact_planes(const RunRecord& run, Section& section) {
  const std::vector<ContactPlane> planes = contact_planes(run.system(), *run.project);
  if (planes.empty()) {
    section.parts.emplace_back(Paragraph{"No joint cuts the solids, and no block lies against another one."});
    return;
  }
  Table table{"Joints: planes in which blocks lie against each other",
              {"Joint", "Between", "and", "Dip / dip direction", "Area (m²)"},
              "lllrr",
              {}};
  std::vector<MeasuredJoint> joints;
  for (const ContactPlane& plane : planes) {
    joints.push_back({.plane = plane.attitude, .set = plane.joint});
    if (table.rows.size() < most_cuts)
      table.rows.push_back(
          {plane.joint, plane.between[0], plane.between[1], dip_text(plane.attitude), format_number(plane.area, 3)});
  }
  section.parts.emplace_back(table);
  if (planes.size() > most_cuts)
    section.parts.emplace_back(more(planes.size() - most_cuts, "smaller plane", "smaller planes"));
  section.parts.emplace_back(net_of(std::move(joints)));
}

/// Whose histories the report shows.
Table monitors(const Project& project) {
  Table table{"Monitors", {"Monitor", "Block", "At (m)"}, "lll", {}};
  for (const Monitor& monitor : project.monitors)
    table.rows.push_back({monitor.name, monitor.block, given(monitor.at)});
  return table;
}

Table blocks(const RunRecord& run) {
  const BlockSystem& system = run.system();
  std::vector<const Block*> by_volume;
  for (const Block& block : system.blocks) by_volume.push_back(&block);
  std::ranges::stable_sort(by_volume, std::greater{}, &Block::volume);
  const std::size_t shown = std::min(most_blocks, by_volume.size());
  Table table{shown < by_volume.size() ? "The " + std::to_string(shown) + " largest blocks" : "Blocks",
              {"Block", "Volume (m³)", "Body", "Material", "Nodes", "Tetrahedra"},
              "lrllrr",
              {}};
  const bool chosen = std::ranges::any_of(system.blocks, [](const Block& block) { return !block.body_reason.empty(); });
  if (chosen) {
    table.heads.push_back("Why this body");
    table.alignment += 'l';
  }
  for (std::size_t i = 0; i < shown; ++i) {
    const Block& block = *by_volume[i];
    const auto material = static_cast<std::size_t>(block.material);
    const bool named = run.project && material < run.project->materials.size();
    std::vector<std::string>& row = table.rows.emplace_back();
    row = {block.name,
           format_number(block.volume, 4),
           std::string(to_string(block.body)),
           named ? run.project->materials[material].name : "–",
           count_text(static_cast<long>(block.mesh.nodes.size())),
           count_text(static_cast<long>(block.mesh.tetrahedra.size()))};
    if (chosen) row.push_back(block.body_reason.empty() ? "the project says so" : block.body_reason);
  }
  return table;
}

}  // namespace

Section model(const RunRecord& run) {
  Section section{"The model", {blocks_in_sum(run)}};
  if (run.project) {
    section.parts.emplace_back(materials(*run.project));
    if (const Table strengths = rock_strengths(*run.project); !strengths.rows.empty())
      section.parts.emplace_back(strengths);
    if (!run.project->joints.empty()) section.parts.emplace_back(joint_strengths(*run.project));
    if (!run.project->cuts.empty())
      add_cuts(*run.project, section);
    else
      add_contact_planes(run, section);
  } else {
    section.parts.emplace_back(
        Paragraph{"Materials and joints are not known here: " + run.why_no_project, Paragraph::Kind::note});
  }
  section.parts.emplace_back(blocks(run));
  if (run.project && !run.project->monitors.empty()) section.parts.emplace_back(monitors(*run.project));
  return section;
}

}  // namespace talus::report
