#include "solve/partwise_search.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using Eigen::VectorXd;

/// Two freedoms, each with the potential Σ cosh(k (x − x₀)) of its own unknowns.
class TwoWells : public testing::Test {
 protected:
  TwoWells() : floor(VectorXd::LinSpaced(6, 0.5, 1)), steep(6) { steep << 1, 1, 1, 8, 8, 8; }
  VectorXd gradient(const VectorXd& d) const {
    return (steep.array() * (steep.array() * (d - floor).array()).sinh()).matrix();
  }
  /// Newton's.
  VectorXd direction(const VectorXd& d) const {
    const Eigen::ArrayXd curvature = steep.array().square() * (steep.array() * (d - floor).array()).cosh();
    return (gradient(d).array() / curvature).matrix();
  }
  static DisjointSets sets(bool together) {
    DisjointSets sets;
    sets.reset(2);
    if (together) sets.join(0, 1);
    return sets;
  }
  /// Where searches along `way` from 0 lead.
  VectorXd floor_along(const VectorXd& way, bool together) {
    DisjointSets parts = sets(together);
    PartwiseSearch search;
    search.set_size(2);
    search.set_parts(parts);
    search.begin(gradient(VectorXd::Zero(6)), way);
    VectorXd step;
    search.step_along(way, step);
    for (int k = 0; k < 60 && search.narrow(gradient(step), way, 0); ++k) search.step_along(way, step);
    EXPECT_FALSE(search.any_pending());
    return step;
  }
  VectorXd floor, steep;
};

TEST_F(TwoWells, each_part_finds_its_own_floor) {
  VectorXd way(6);
  way << -floor.head(3), -5 * floor.tail(3);  // to the floor, and five times as far
  const VectorXd apart = floor_along(way, false), together = floor_along(way, true);
  EXPECT_LT((apart.head(3) - floor.head(3)).norm(), 1e-12) << "the full step, although the other part needs a search";
  const auto slope = [&](const VectorXd& d) { return std::abs(gradient(d).tail(3).dot(way.tail(3))); };
  EXPECT_LT(slope(apart), 0.1 * slope(VectorXd::Zero(6)));
  EXPECT_LT(apart[3], 2 * floor[3]) << "not five times as far";
  EXPECT_GT((together.head(3) - floor.head(3)).norm(), 0.3) << "one share for both";
}

TEST_F(TwoWells, a_part_that_leads_on_stays_and_the_other_goes_back) {
  DisjointSets parts = sets(false);
  PartwiseSearch search;
  search.set_size(2);
  search.set_parts(parts);
  VectorXd start = VectorXd::Zero(6), d(6), way(6), picked;
  way << -floor.head(3), -5 * floor.tail(3);
  search.begin(gradient(start), way);
  search.step_along(way, d);
  search.leave(gradient(d), way,
               [](const PartwiseSearch::State& part) { return part.residual < 0.9 * part.residual_before; });
  ASSERT_TRUE(search.any_pending());
  search.pick_pending(VectorXd::Ones(6), picked);
  EXPECT_EQ(picked, (VectorXd(6) << 0, 0, 0, 1, 1, 1).finished());
  search.go_back(start, d);
  EXPECT_EQ(d.head(3), floor.head(3));
  EXPECT_EQ(start.head(3), floor.head(3)) << "further searches begin where it stays";
  EXPECT_EQ(d.tail(3), VectorXd::Zero(3));
}

TEST_F(TwoWells, a_part_that_is_nearly_in_balance_is_left) {
  DisjointSets parts = sets(false);
  PartwiseSearch search;
  search.set_size(2);
  search.set_parts(parts);
  VectorXd near = floor, step;
  near[0] += 1e-6;
  near[3] += 0.3;
  search.begin(gradient(near), -direction(near));  // both go the wrong way
  search.step_along(-direction(near), step);
  ASSERT_TRUE(search.narrow(gradient(near + step), -direction(near), 1e-4));
  search.step_along(-direction(near), step);
  EXPECT_EQ(step.head(3), direction(near).head(3)) << "the full step";
  EXPECT_NE(step.tail(3), direction(near).tail(3));
}

/// A contact closes at a share of the step, and makes the slope rise by a million times as much from there on.
TEST(PartwiseSearch, finds_where_a_contact_closes_in_a_few_trials) {
  for (const double closes : {1e-5, 0.03, 0.3, 0.77}) {
    const auto gradient = [&](const VectorXd& d) {
      VectorXd g = d - VectorXd::Unit(3, 0);
      g[0] += 1e6 * std::max(0.0, d[0] - closes);
      return g;
    };
    PartwiseSearch search;
    search.set_size(1);
    const VectorXd way = -VectorXd::Unit(3, 0);
    VectorXd step;
    search.begin(gradient(VectorXd::Zero(3)), way);
    search.step_along(way, step);
    int trials = 0;
    for (; search.narrow(gradient(step), way, 0); ++trials) search.step_along(way, step);
    EXPECT_LE(trials, 5) << closes;
    EXPECT_NEAR(step[0], closes, 2e-6);
  }
}

TEST_F(TwoWells, a_part_without_a_direction_is_left) {
  DisjointSets parts = sets(false);
  PartwiseSearch search;
  search.set_size(2);
  search.set_parts(parts);
  search.begin(gradient(floor), direction(floor));
  EXPECT_FALSE(search.any_pending());
  search.take_all();
  EXPECT_TRUE(search.any_pending());
}

}  // namespace
}  // namespace talus
