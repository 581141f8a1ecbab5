#include "solve/equilibrium/partwise_line_search.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using Eigen::VectorXd;

/// Two degree-of-freedom blocks, each with the potential Σ cosh(k (x − x₀)) of its own unknowns.
class TwoWells : public testing::Test {
 protected:
  TwoWells() : minimum(VectorXd::LinSpaced(6, 0.5, 1)), steep(6) { steep << 1, 1, 1, 8, 8, 8; }
  VectorXd gradient(const VectorXd& d) const {
    return (steep.array() * (steep.array() * (d - minimum).array()).sinh()).matrix();
  }
  /// Newton's.
  VectorXd direction(const VectorXd& d) const {
    const Eigen::ArrayXd curvature = steep.array().square() * (steep.array() * (d - minimum).array()).cosh();
    return (gradient(d).array() / curvature).matrix();
  }
  static DisjointSets sets(bool together) {
    DisjointSets sets;
    sets.reset(2);
    if (together) sets.join(0, 1);
    return sets;
  }
  /// Where searches along `along` from 0 lead.
  VectorXd minimum_along(const VectorXd& along, bool together) {
    DisjointSets parts = sets(together);
    PartwiseLineSearch search;
    search.set_size(2);
    search.set_parts(parts);
    search.begin(gradient(VectorXd::Zero(6)), along);
    VectorXd increment;
    search.increment_along(along, increment);
    for (int k = 0; k < 60 && search.narrow(gradient(increment), along); ++k) search.increment_along(along, increment);
    EXPECT_FALSE(search.any_pending());
    return increment;
  }
  VectorXd minimum, steep;
};

TEST_F(TwoWells, EachPartFindsItsOwnMinimum) {
  VectorXd along(6);
  along << -minimum.head(3), -5 * minimum.tail(3);  // to the minimum, and five times as far
  const VectorXd apart = minimum_along(along, false), together = minimum_along(along, true);
  EXPECT_LT((apart.head(3) - minimum.head(3)).norm(), 1e-12)
      << "the full increment, although the other part needs a search";
  const auto slope = [&](const VectorXd& d) { return std::abs(gradient(d).tail(3).dot(along.tail(3))); };
  EXPECT_LT(slope(apart), 0.1 * slope(VectorXd::Zero(6)));
  EXPECT_LT(apart[3], 2 * minimum[3]) << "not five times as far";
  EXPECT_GT((together.head(3) - minimum.head(3)).norm(), 0.3) << "one fraction for both";
}

TEST_F(TwoWells, PartThatLeadsOnStaysAndTheOtherGoesBack) {
  DisjointSets parts = sets(false);
  PartwiseLineSearch search;
  search.set_size(2);
  search.set_parts(parts);
  VectorXd start = VectorXd::Zero(6), d(6), along(6), picked;
  along << -minimum.head(3), -5 * minimum.tail(3);
  search.begin(gradient(start), along);
  search.increment_along(along, d);
  search.keep(gradient(d), along,
              [](const PartwiseLineSearch::State& part) { return part.residual < 0.9 * part.residual_before; });
  ASSERT_TRUE(search.any_pending());
  search.pick_pending(VectorXd::Ones(6), picked);
  EXPECT_EQ(picked, (VectorXd(6) << 0, 0, 0, 1, 1, 1).finished());
  search.go_back(start, d);
  EXPECT_EQ(d.head(3), minimum.head(3));
  EXPECT_EQ(start.head(3), minimum.head(3)) << "further searches begin where it stays";
  EXPECT_EQ(d.tail(3), VectorXd::Zero(3));
}

TEST_F(TwoWells, PartWithANegligibleResidualIsDone) {
  DisjointSets parts = sets(false);
  PartwiseLineSearch search;
  search.set_size(2);
  search.set_parts(parts);
  VectorXd near = minimum, increment;
  near[0] += 1e-6;
  near[3] += 0.3;
  const double negligible[] = {1e-4, 1e-4};
  search.begin(gradient(near), -direction(near), negligible);  // both go the wrong way
  search.increment_along(-direction(near), increment);
  ASSERT_TRUE(search.narrow(gradient(near + increment), -direction(near)));
  search.increment_along(-direction(near), increment);
  EXPECT_EQ(increment.head(3), direction(near).head(3)) << "the full increment";
  EXPECT_NE(increment.tail(3), direction(near).tail(3));
}

/// A contact closes after a fraction of the increment, and makes the slope rise by a million times as much from there
/// on.
TEST(PartwiseLineSearch, FindsWhereAContactClosesInAFewTrials) {
  for (const double closes : {1e-5, 0.03, 0.3, 0.77}) {
    const auto gradient = [&](const VectorXd& d) {
      VectorXd g = d - VectorXd::Unit(3, 0);
      g[0] += 1e6 * std::max(0.0, d[0] - closes);
      return g;
    };
    PartwiseLineSearch search;
    search.set_size(1);
    const VectorXd along = -VectorXd::Unit(3, 0);
    VectorXd increment;
    search.begin(gradient(VectorXd::Zero(3)), along);
    search.increment_along(along, increment);
    int trials = 0;
    for (; search.narrow(gradient(increment), along); ++trials) search.increment_along(along, increment);
    EXPECT_LE(trials, 5) << closes;
    EXPECT_NEAR(increment[0], closes, 2e-6);
  }
}

TEST_F(TwoWells, PartWithoutADirectionIsDone) {
  DisjointSets parts = sets(false);
  PartwiseLineSearch search;
  search.set_size(2);
  search.set_parts(parts);
  search.begin(gradient(minimum), direction(minimum));
  EXPECT_FALSE(search.any_pending());
  search.set_all_pending();
  EXPECT_TRUE(search.any_pending());
}

}  // namespace
}  // namespace talus
