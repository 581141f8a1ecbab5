// What templates make is cut, meshed and run; where the outcome is known by hand, it is that one.
#include <gmock/gmock.h>

#include <cmath>

#include "base/units.hpp"
#include "geometry/block_builder.hpp"
#include "solve/simulation.hpp"
#include "templates/templates.hpp"

namespace talus {
namespace {

constexpr double gravity = 9.81;  // m/s²

BlockSystem blocks_of(const Project& project) {
  NoProgress progress;
  return build_blocks(project, ".", progress);
}

int free_blocks(const BlockSystem& system) {
  int count = 0;
  for (const Block& block : system.blocks) count += block.body != BodyKind::fixed;
  return count;
}

/// A run of a template's project.
struct TemplateRun {
  TemplateRun(const std::string& key, const TemplateValues& values)
      : project(project_from(template_named(key), values)), system(blocks_of(project)), simulation(project, system) {}

  /// How far each monitor goes in the first `seconds` of the dynamic stage [m].
  std::vector<Vec3> paths(double seconds) {
    do {
      simulation.step();
    } while (simulation.converged() && !simulation.stage_ended());
    const HistoryRow start = simulation.history();
    while (simulation.converged() && simulation.time() < start.time + seconds - 1e-9) simulation.step();
    EXPECT_TRUE(simulation.converged()) << project.name << ": " << simulation.failure();
    std::vector<Vec3> gone;
    for (std::size_t i = 0; i < start.monitors.size(); ++i)
      gone.push_back(simulation.history().monitors[i].displacement - start.monitors[i].displacement);
    return gone;
  }

  Project project;
  BlockSystem system;
  Simulation simulation;
};

/// Of the first monitor.
Vec3 path(const std::string& key, const TemplateValues& values, double seconds) {
  return TemplateRun(key, values).paths(seconds).at(0);
}

Vec3 down(double plunge, double length) {
  return length * Vec3(std::cos(radians(plunge)), 0, -std::sin(radians(plunge)));
}

class EveryTemplate : public testing::TestWithParam<std::string> {};

TEST_P(EveryTemplate, CutsMeshesAndRunsItsFirstSteps) {
  const ProjectTemplate& chosen = template_named(GetParam());
  TemplateValues least, most;
  for (const TemplateNumber& number : chosen.numbers) {
    least[number.key] = number.least;
    most[number.key] = number.most;
  }
  for (const TemplateValues& values : {TemplateValues{}, least, most}) {
    const Project project = project_from(chosen, values);
    const BlockSystem system = blocks_of(project);
    EXPECT_GT(free_blocks(system), 0) << chosen.key;
    Simulation simulation(project, system);
    for (int step = 0; step < 3; ++step) simulation.step();
    EXPECT_TRUE(simulation.converged()) << chosen.key << ": " << simulation.failure();
  }
}

TEST_P(EveryTemplate, IsCutAtEveryEndOfItsRanges) {
  const ProjectTemplate& chosen = template_named(GetParam());
  for (const TemplateNumber& number : chosen.numbers) {
    for (const double end : {number.least, number.most})
      EXPECT_GT(free_blocks(blocks_of(project_from(chosen, {{number.key, end}}))), 0) << number.key << ' ' << end;
  }
}

INSTANTIATE_TEST_SUITE_P(Templates, EveryTemplate,
                         testing::Values("bench-slope", "wedge", "toppling-face", "column", "tunnel-roof", "cavern",
                                         "dry-stone-wall"),
                         [](const auto& tested) {
                           std::string name;
                           for (const char letter : tested.param)
                             if (letter != '-') name += letter;
                           return name;
                         });

/// Degrees; at this friction the wedge is in limit equilibrium (Hoek & Bray).
double critical_friction(double plunge, double wedge_angle) {
  return degrees(std::atan(std::tan(radians(plunge)) * std::sin(radians(wedge_angle / 2))));
}

TEST(WedgeTemplate, SlidesAlongTheLineOfIntersectionAsByHand) {
  constexpr double plunge = 40, wedge_angle = 100, friction = 25, seconds = 0.3;
  const double acceleration =
      gravity * (std::sin(radians(plunge)) -
                 std::cos(radians(plunge)) * std::tan(radians(friction)) / std::sin(radians(wedge_angle / 2)));
  const Vec3 by_hand = down(plunge, acceleration * seconds * seconds / 2);
  const Vec3 gone = path("wedge", {{"plunge", plunge}, {"wedge_angle", wedge_angle}, {"friction", friction}}, seconds);
  EXPECT_NEAR((gone - by_hand).norm(), 0, 0.02 * by_hand.norm())
      << gone.transpose() << " by hand " << by_hand.transpose();
}

TEST(WedgeTemplate, SlidesJustBelowTheCriticalFrictionAndStaysJustAbove) {
  const double critical = critical_friction(35, 90);
  const auto gone = [&](double friction) {
    return path("wedge", {{"plunge", 35}, {"wedge_angle", 90}, {"friction", friction}}, 0.3).norm();
  };
  EXPECT_GT(gone(critical - 1), 2e-3);
  EXPECT_LT(gone(critical + 1), 2e-4);
}

TEST(BenchSlopeTemplate, ItsThreeSlabsSlideAsByHand) {
  constexpr double dip = 40, friction = 30, seconds = 0.2;
  const double acceleration = gravity * (std::sin(radians(dip)) - std::cos(radians(dip)) * std::tan(radians(friction)));
  const Vec3 by_hand = down(dip, acceleration * seconds * seconds / 2);
  TemplateRun run("bench-slope", {{"joint_dip", dip}, {"friction", friction}, {"width", 30}});
  for (const Vec3& gone : run.paths(seconds))
    EXPECT_NEAR((gone - by_hand).norm(), 0, 0.02 * by_hand.norm())
        << gone.transpose() << " by hand " << by_hand.transpose();
}

TEST(ColumnTemplate, SlidesAsByHand) {
  constexpr double dip = 30, friction = 15, seconds = 0.3;
  const double acceleration = gravity * (std::sin(radians(dip)) - std::cos(radians(dip)) * std::tan(radians(friction)));
  const Vec3 by_hand = down(dip, acceleration * seconds * seconds / 2);
  const Vec3 gone = path("column", {{"height", 1}, {"width", 2}, {"dip", dip}, {"friction", friction}}, seconds);
  EXPECT_NEAR((gone - by_hand).norm(), 0, 0.02 * by_hand.norm())
      << gone.transpose() << " by hand " << by_hand.transpose();
}

TEST(ColumnTemplate, TopplesWhereItIsMoreSlenderThanTheDipAllows) {
  const double limit = degrees(std::atan(1.0 / 4));  // of the dip, for a column of 1 m × 4 m
  const auto head = [&](double dip) { return path("column", {{"dip", dip}, {"friction", 45}}, 0.6).x(); };
  EXPECT_GT(head(limit + 2), 0.02);
  EXPECT_LT(std::abs(head(limit - 2)), 1e-3);
}

TEST(TunnelRoofTemplate, ThePrismFallsFreelyUnlessTheRockPressesIt) {
  constexpr double seconds = 0.3;
  const Vec3 fallen = path("tunnel-roof", {}, seconds);
  EXPECT_NEAR(fallen.z(), -gravity * seconds * seconds / 2, 0.02 * gravity * seconds * seconds / 2);
  EXPECT_LT(path("tunnel-roof", {{"joint_dip", 75}, {"stress", 1000}}, seconds).norm(), 5e-3);
}

TEST(DryStoneWallTemplate, OverturnsWhereTheTiltExceedsThicknessOverHeight) {
  const double limit = degrees(std::atan(1.5 / 5));  // of five courses
  const auto head = [&](double tilt) {
    return path("dry-stone-wall", {{"tilt", tilt}, {"stones", 1}, {"friction", 50}}, 0.5).y();
  };
  EXPECT_GT(head(limit + 3), 0.02);
  EXPECT_LT(std::abs(head(limit - 3)), 1e-3);
}

}  // namespace
}  // namespace talus
