#include <algorithm>
#include <map>

#include "model/number_text.hpp"
#include "orientation/project_joints.hpp"
#include "render/paint/numbers.hpp"
#include "render/stereonet/stereonet_picture.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

constexpr std::size_t most_blocks = 20, most_cuts = 40;

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
    facts.rows.push_back({"Gravity", vector_text(run.project->gravity) + " m/s²  (x east, y north, z up)"});
    if (!run.project->origin.isZero()) facts.rows.push_back({"Local origin", vector_text(run.project->origin) + " m"});
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

Table strengths(const Project& project) {
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

Table attitudes(const Project& project) {
  Table table{"Joints: attitude",
              {"Joint", "Dip / dip direction", "Planes", "Spacing (m)", "Through (m)", "Extent"},
              "llrrll",
              {}};
  for (const Cut& cut : project.cuts) {
    if (table.rows.size() == most_cuts) break;
    table.rows.push_back({cut.joint, given(cut.dip) + "° / " + given(cut.dip_direction) + "°",
                          cut.network ? "–" : std::to_string(cut.count.value_or(1)),
                          cut.spacing && cut.count.value_or(1) > 1 ? given(*cut.spacing) : "–",
                          vector_text(cut.through), extent_text(cut)});
  }
  return table;
}

Chart net_of(const Project& project) {
  Stereonet net;
  net.joints = joints_of(project, 2000).joints;
  net.paper = paper;
  return {stereonet_painting(net, "Poles of the joints"), 700, 400,
          "Lower hemisphere, equal area; poles, and great circles of the sets’ means."};
}

Table interfaces(const Project& project) {
  Table table{"Joints between blocks", {"Between", "and", "Joint"}, "lll", {}};
  for (const Interface& interface : project.interfaces) {
    if (table.rows.size() == most_cuts) break;
    table.rows.push_back({interface.between[0], interface.between[1], interface.joint});
  }
  if (!project.default_joint.empty()) table.rows.push_back({"all others", "", project.default_joint});
  return table;
}

Paragraph more(std::size_t count, const char* one, const char* many) {
  return {"… and " + counted_text(static_cast<long>(count), one, many) + ".", Paragraph::Kind::note};
}

void add_joints(const Project& project, Section& section) {
  if (!project.joints.empty()) section.parts.emplace_back(strengths(project));
  if (project.cuts.empty()) {
    section.parts.emplace_back(Paragraph{"No joint cuts the solids: the blocks are as the project describes them."});
  } else {
    section.parts.emplace_back(attitudes(project));
    if (project.cuts.size() > most_cuts)
      section.parts.emplace_back(more(project.cuts.size() - most_cuts, "more cut", "more cuts"));
    section.parts.emplace_back(net_of(project));
  }
  if (project.interfaces.empty()) return;
  section.parts.emplace_back(interfaces(project));
  if (project.interfaces.size() > most_cuts)
    section.parts.emplace_back(
        more(project.interfaces.size() - most_cuts, "more pair of blocks", "more pairs of blocks"));
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
    add_joints(*run.project, section);
  } else {
    section.parts.emplace_back(
        Paragraph{"Materials and joints are not known here: " + run.why_no_project, Paragraph::Kind::note});
  }
  section.parts.emplace_back(blocks(run));
  return section;
}

}  // namespace talus::report
