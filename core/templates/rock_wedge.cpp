#include <cmath>

#include "base/units.hpp"
#include "templates/shapes.hpp"
#include "templates/structures.hpp"

namespace talus {

namespace {

/// A face that two joints, alike to both sides, cut a wedge out of; their line of intersection plunges out of it. The
/// wedge's factor of safety is tan φ / (sin(ξ/2) tan ψ), with the angle ξ between the joints and the plunge ψ (Hoek &
/// Bray, Rock Slope Engineering, chapter 8, with β = 90°).
Project make_rock_wedge(const TemplateValues& values) {
  const double height = values.at("height"), face = radians(values.at("face_angle"));
  const double plunge = radians(values.at("plunge")), half_angle = radians(values.at("wedge_angle")) / 2;
  const double foot = daylight * height, rise = height - foot;
  const Vec3 exit(-foot / std::tan(face), 0, foot);
  // Where the line comes up on top, and how far the joints have opened at the crest.
  const double top_end = exit.x() - rise / std::tan(plunge), crest = -height / std::tan(face);
  const double half_width = rise * std::sin(face - plunge) / std::sin(face) * std::tan(half_angle);
  const double width = 1.4 * half_width, back = 1.25 * top_end, floor = -height / 4;

  Project project = rock_with_joints("Rock wedge", values.at("friction"));
  project.solids = {
      fixed_rock("rock", prism({{back, floor}, {0, floor}, {0, 0}, {crest, height}, {back, height}}, -width, width),
                 height / 3),
      fixed_rock("ground", BoxShape{{0, -width, floor}, {height, width, 0}}, height / 3)};
  for (const double side : {1.0, -1.0}) {
    const Vec3 normal(std::sin(plunge) * std::sin(half_angle), side * std::cos(half_angle),
                      std::cos(plunge) * std::sin(half_angle));
    const double direction = degrees(std::atan2(normal.x(), normal.y()));
    project.cuts.push_back(joint_plane(degrees(std::acos(normal.z())), direction, exit, "rock"));
  }
  const Vec3 inside = (exit + Vec3(crest, 0, height) + Vec3(top_end, 0, height)) / 3;
  add_named_block(project, "wedge", inside, BodyKind::automatic);
  add_stages(project, height, std::sqrt(height) / 2);
  return project;
}

}  // namespace

ProjectTemplate rock_wedge() {
  return {"wedge",
          "Wedge",
          "A rock face and the wedge that two joints cut out of it, alike to both sides. It slides along their line of "
          "intersection where tan φ is below sin(ξ/2) tan ψ.",
          {{"height", "Slope height", "from toe to crest", "m", 2, 100, 12},
           {"face_angle", "Face angle", "from the horizontal", "°", 60, 85, 70},
           {"plunge", "Plunge ψ", "of the joints' line of intersection", "°", 20, 50, 40},
           {"wedge_angle", "Wedge angle ξ", "between the two joints", "°", 60, 120, 100},
           {"friction", "Friction angle φ", "of both joints", "°", 0, 60, 30}},
          make_rock_wedge};
}

}  // namespace talus
