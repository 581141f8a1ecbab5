#pragma once

#include <functional>
#include <limits>
#include <ostream>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "model/rules/validate.hpp"

namespace talus::test {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A slope cut once, with something of every kind.
inline Project slope() {
  Project project;
  project.materials = {{"rock", 2600, 25e9, 0.24}};
  Joint joint;
  joint.name = "J1";
  joint.friction_angle = 30;
  project.joints = {joint};
  project.default_joint = "J1";
  Solid solid{.name = "slope", .shape = BoxShape{{0, 0, 0}, {10, 10, 10}}, .material = "rock", .mesh_size = 2};
  project.solids = {solid};
  Cut cut;
  cut.joint = "J1";
  cut.dip = 35;
  cut.dip_direction = 120;
  cut.through = {5, 5, 5};
  project.cuts = {cut};
  BlockOverride top;
  top.name = "top";
  top.at = {5, 5, 9};
  project.blocks = {top};
  project.interfaces = {{{"top", "slope.1"}, "J1"}};
  project.constraints = {{"slope.1", Vec3(0, 0, 0), {0.0, std::nullopt, 0.0}, {}}};
  project.loads = {{"top", {5, 5, 10}, {0, 0, -1e6}, {}}};
  project.velocities = {{"top", {1, 0, 0}, {0, 0, 0}}};
  InSituStress weight;
  weight.stress << -1e5, -1e5, -2e5, 0, 0, 0;
  project.in_situ = {weight};
  Stage stage;
  stage.name = "slide";
  stage.time_step = 0.01;
  stage.duration = 2;
  project.stages = {stage};
  project.monitors = {{"P1", "top", {5, 5, 10}}};
  project.expect = {{"P1.displacement.z", 1, -4.9, 1e-6, std::nullopt, "known"},
                    {"top.velocity.magnitude", 2, 1, 0.1, 0.5, ""}};
  return project;
}

/// The slope, spoilt.
struct BadProject {
  std::string what;
  std::function<void(Project&)> spoil;
  std::string place, problem, remedy;
};

inline std::ostream& operator<<(std::ostream& out, const BadProject& bad) { return out << bad.what; }

inline void expect_refused(const BadProject& bad) {
  Project project = slope();
  bad.spoil(project);
  try {
    validate(project);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), bad.place);
    EXPECT_THAT(error.problem(), testing::HasSubstr(bad.problem));
    EXPECT_THAT(error.remedy(), testing::HasSubstr(bad.remedy));
  }
}

}  // namespace talus::test
