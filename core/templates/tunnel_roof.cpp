#include <cmath>

#include "base/units.hpp"
#include "templates/shapes.hpp"
#include "templates/structures.hpp"

namespace talus {

namespace {

constexpr double prism_width = 0.8;  // of the span

/// A tunnel with a flat roof, and the prism of rock between two joints that rise from it and meet above it. The joints
/// open downwards: nothing but a horizontal stress in the rock holds the prism.
Project make_tunnel_roof(const TemplateValues& values) {
  const double span = values.at("span"), height = values.at("height"), dip = values.at("joint_dip");
  const double foot = prism_width * span / 2, apex = foot * std::tan(radians(dip)), top = height + apex + span / 2;
  const double wall = span / 2 + (top - height) / std::tan(radians(dip)) + span / 4, half = span / 2;
  const auto box = [&](double x0, double x1, double z0, double z1) {
    return BoxShape{{x0, -half, z0}, {x1, half, z1}};
  };
  Project project = rock_with_joints("Tunnel roof", values.at("friction"));
  project.solids = {fixed_rock("roof", box(-wall, wall, height, top), span / 2),
                    fixed_rock("west wall", box(-wall, -span / 2, 0, height), span / 2),
                    fixed_rock("east wall", box(span / 2, wall, 0, height), span / 2),
                    fixed_rock("floor", box(-wall, wall, -span / 4, 0), span / 2)};
  project.cuts = {joint_plane(dip, 270, Vec3(-foot, 0, height), "roof"),
                  joint_plane(dip, 90, Vec3(foot, 0, height), "roof")};
  const Vec3 inside(0, 0, height + apex / 3);
  add_named_block(project, "prism", inside, BodyKind::tetrahedra);
  project.blocks.back().mesh_size = span / 3;
  if (const double stress = values.at("stress") * 1e3; stress > 0) {
    InSituStress in_situ;
    in_situ.blocks = {"prism"};
    in_situ.stress[0] = -stress;
    project.in_situ = {in_situ};
  }
  add_stages(project, span, std::sqrt(2 * height / 9.81));
  return project;
}

}  // namespace

ProjectTemplate tunnel_roof() {
  return {"tunnel-roof",
          "Tunnel roof",
          "A tunnel with a flat roof, and the prism between two joints that rise from it. Without horizontal "
          "stress in the rock it falls.",
          {{"span", "Span", "width of the tunnel", "m", 1, 30, 6},
           {"height", "Height", "of the tunnel", "m", 1, 30, 5},
           {"joint_dip", "Joint dip", "of both joints, away from the tunnel", "°", 30, 80, 60},
           {"friction", "Friction angle", "of both joints", "°", 0, 60, 35},
           {"stress", "Horizontal stress", "across the tunnel, before the prism is loosened", "kPa", 0, 2000, 0}},
          make_tunnel_roof};
}

}  // namespace talus
