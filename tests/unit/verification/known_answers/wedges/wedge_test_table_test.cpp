#include "verification/known_answers/wedges/wedge_test_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using namespace talus;
using testing::DoubleNear;
using testing::Pointwise;

/// Factors of safety by limit equilibrium at 32.5°, computed apart from this program, in the tables' order.
constexpr std::array<double, 65> factors{
    1.9749, 1.3661, 1.044,  0.9896, 0.72,   0.5062, 0.3648, 0.2852, 0.2062, 0.1286, 0.0523, 1.9749, 1.3063,
    1.0097, 0.9153, 0.6452, 0.4365, 0.2609, 0.1215, 0.0433, 0,      0,      1.9749, 3.2365, 8.0394, 16.8482,
    3.9377, 2.1093, 1.3468, 0.9776, 0.9081, 0.6279, 0.47,   0.7802, 0.5735, 0.4063, 0.2734, 0.2051, 0.1363,
    0.0677, 0,      0,      0,      0.7802, 0.5494, 0.3685, 0.2146, 0.0909, 0.0079, 0,      0,      0,
    0,      0.7802, 0.9797, 0.9866, 1.2568, 1.7011, 2.6074, 5.8924, 5.3915, 2.2383, 1.3254, 1.0766, 0.8908};

constexpr double printed = 0.0051;  // cells have two digits

Vec3 steepest_descent(const Vec3& normal) {
  const Vec3 down = -Vec3::UnitZ();
  return (down - down.dot(normal) * normal).normalized();
}

Vec3 downwards(const Vec3& line) { return line.z() < 0 ? line : Vec3(-line); }

int count(bool (*agree)(const WedgeTest&)) {
  return static_cast<int>(std::count_if(wedge_tests().begin(), wedge_tests().end(), agree));
}

TEST(WedgeTestTable, HoldsBothTablesOfThePaper) {
  std::set<std::string> names;
  for (const WedgeTest& test : wedge_tests()) names.insert(test.name());
  EXPECT_EQ(names.size(), 65u);
  EXPECT_EQ(count([](const WedgeTest& test) { return test.block == 1; }), 33);
  EXPECT_EQ(count([](const WedgeTest& test) { return test.block == 2; }), 32);
}

TEST(WedgeTestTable, ShapeAndTurnGiveEveryPrintedDirectionOfPlanesAndLine) {
  for (const WedgeTest& test : wedge_tests()) {
    SCOPED_TRACE(test.name());
    const WedgePlanes planes = turned(test.shape().planes(), test.turn());
    EXPECT_THAT(steepest_descent(planes.normals[0]), Pointwise(DoubleNear(printed), test.descent_1));
    EXPECT_THAT(steepest_descent(planes.normals[1]), Pointwise(DoubleNear(printed), test.descent_2));
    EXPECT_THAT(downwards(planes.line), Pointwise(DoubleNear(printed), test.line));
  }
}

TEST(WedgeTestTable, LimitEquilibriumHasTheFactorsComputedElsewhere) {
  for (std::size_t i = 0; i < factors.size(); ++i)
    EXPECT_NEAR(wedge_tests()[i].equilibrium().factor(plaster_friction_angle), factors[i], 6e-5)
        << wedge_tests()[i].name();
}

TEST(WedgeTestTable, ColumnsAgreeInAsManyRowsAsThePaperSays) {
  EXPECT_EQ(count([](const WedgeTest& test) { return test.coupled == test.physical; }), 62);
  EXPECT_EQ(count([](const WedgeTest& test) { return test.coupled == test.equilibrium().mode(32.5); }), 61);
  EXPECT_EQ(count([](const WedgeTest& test) { return test.physical == test.equilibrium().mode(32.5); }), 58);
}

TEST(WedgeTestTable, CoupledMethodPrintsADirectionWhereItsWedgeMoves) {
  for (const WedgeTest& test : wedge_tests()) {
    const Vec3 direction(test.coupled_direction.data());
    if (test.coupled == WedgeMode::stable)
      EXPECT_TRUE(direction.isZero()) << test.name();
    else
      EXPECT_NEAR(direction.norm(), 1, 0.02) << test.name();
  }
}

TEST(WedgeTestTable, FrictionBetween26And27DegreesSeparatesWhatStayedFromWhatMoved) {
  double stayed = 0, moved = 90;
  for (const WedgeTest& test : wedge_tests()) {
    const double critical = test.equilibrium().critical_friction_angle();
    if (test.physical == WedgeMode::stable)
      stayed = std::max(stayed, critical);
    else
      moved = std::min(moved, critical);
  }
  EXPECT_NEAR(stayed, 25.997, 1e-3);
  EXPECT_NEAR(moved, 26.880, 1e-3);
}

}  // namespace
