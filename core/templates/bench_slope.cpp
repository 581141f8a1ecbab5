#include <cmath>

#include "base/units.hpp"
#include "templates/shapes.hpp"
#include "templates/structures.hpp"

namespace talus {

namespace {

constexpr int benches = 3;

/// One bench above the other, each with a joint that daylights above its toe: what lies on the joint slides where it
/// dips steeper than its friction angle.
Project make_bench_slope(const TemplateValues& values) {
  const double height = values.at("height"), width = values.at("width"), dip = values.at("joint_dip");
  const double run = height / std::tan(radians(values.at("face_angle")));     // of a face, in plan
  const double joint_run = (1 - daylight) * height / std::tan(radians(dip));  // of a joint, from face to bench level
  const double back = -(benches * (run + width) + joint_run), half = height / 2;
  Project project = rock_with_joints("Bench slope", values.at("friction"));
  project.solids = {fixed_rock("floor", BoxShape{{back, -half, -half}, {width, half, 0}}, height / 2)};
  for (int i = 0; i < benches; ++i) {
    const double toe = -i * (run + width), foot = i * height;
    const std::string number = std::to_string(i + 1);
    const std::vector<SectionPoint> profile{
        {back, foot}, {toe, foot}, {toe - run, foot + height}, {back, foot + height}};
    project.solids.push_back(fixed_rock("bench " + number, prism(profile, -half, half), height / 2));
    const Vec3 exit(toe - daylight * run, 0, foot + daylight * height), crest(toe - run, 0, foot + height);
    project.cuts.push_back(joint_plane(dip, 90, exit, "bench " + number));
    const Vec3 back_end(exit.x() - joint_run, 0, foot + height);
    add_named_block(project, "slab " + number, (exit + crest + back_end) / 3, BodyKind::automatic);
  }
  add_stages(project, height, std::sqrt(height) / 2);
  return project;
}

}  // namespace

ProjectTemplate bench_slope() {
  return {"bench-slope",
          "Bench slope",
          "Three benches of a pit, each with a joint that daylights above its toe. A slab slides where its joint is "
          "steeper "
          "than its friction angle.",
          {{"height", "Bench height", "from bench to bench", "m", 2, 40, 10},
           {"face_angle", "Face angle", "of the faces, from the horizontal", "°", 55, 85, 70},
           {"width", "Bench width", "from crest to the next toe", "m", 1, 40, 6},
           {"joint_dip", "Joint dip", "towards the pit", "°", 15, 45, 35},
           {"friction", "Friction angle", "of the joints", "°", 0, 60, 30}},
          make_bench_slope};
}

}  // namespace talus
