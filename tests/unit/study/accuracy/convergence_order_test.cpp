#include "study/accuracy/convergence_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace talus {
namespace {

/// Distances from the finest of answers that are off by `constant`·sizeᵖ.
std::vector<AxisDistance> distances(double finest, const std::vector<double>& sizes, double order, double constant) {
  std::vector<AxisDistance> list;
  for (const double size : sizes) list.push_back({size, constant * (std::pow(size, order) - std::pow(finest, order))});
  return list;
}

TEST(ConvergenceOrder, OfAKnownSequenceIsFound) {
  for (const double order : {0.5, 1.0, 2.0, 3.0}) {
    const auto fit = fit_order(0.25, distances(0.25, {0.5, 1, 2, 4}, order, 0.03), order);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->convergence, Convergence::converging);
    EXPECT_NEAR(fit->order, order, 1e-6);
    EXPECT_NEAR(fit->misfit, 0, 1e-6);
    EXPECT_NEAR(fit->finest_error, 0.03 * std::pow(0.25, order), 1e-8);
  }
}

TEST(ConvergenceOrder, TwoDistancesAreFittedExactly) {
  const auto fit = fit_order(0.5, distances(0.5, {1, 2}, 2, 0.1), 2);
  EXPECT_NEAR(fit->order, 2, 1e-6);
  EXPECT_NEAR(fit->finest_error, 0.025, 1e-8);
}

TEST(ConvergenceOrder, AboveTheoryIsNotTrusted) {
  const auto list = distances(0.5, {1, 2}, 4, 0.1);
  const auto fit = fit_order(0.5, list, 1);
  EXPECT_NEAR(fit->order, 4, 1e-6);
  EXPECT_NEAR(fit->finest_error, list[0].distance, 1e-12);  // 2¹ − 1 = 1
}

TEST(ConvergenceOrder, AboveTheoryIsTrustedWhereThreeDistancesFit) {
  const auto list = distances(0.25, {0.5, 1, 2}, 2, 0.03);
  const auto fit = fit_order(0.25, list, 1);
  EXPECT_NEAR(fit->order, 2, 1e-6);
  EXPECT_NEAR(fit->finest_error, 0.03 * 0.25 * 0.25, 1e-8);
  auto scattered = list;
  scattered[1].distance *= 1.5;
  const auto doubtful = fit_order(0.25, scattered, 1);
  EXPECT_GT(doubtful->misfit, good_fit);
  EXPECT_NEAR(doubtful->finest_error, list[0].distance, 1e-12);  // 2¹ − 1 = 1
}

TEST(ConvergenceOrder, IsToldWithHowMuchTheAxisMatters) {
  const auto list = distances(0.25, {0.5, 1, 4}, 2, 0.03);
  EXPECT_EQ(fit_order(0.25, list, 2)->spread, list.back().distance);
}

TEST(ConvergenceOrder, WhereTheoryKnowsNoneIsTheLargestDistance) {
  const auto fit = fit_order(0.5, distances(0.5, {1}, 2, 0.1), std::nullopt);
  EXPECT_EQ(fit->convergence, Convergence::not_expected);
  EXPECT_EQ(fit->finest_error, fit->spread);
  EXPECT_EQ(fit_order(0.5, std::vector<AxisDistance>{{1, 1e-12}}, std::nullopt)->convergence, Convergence::exact);
}

TEST(ConvergenceOrder, OfScatteredDistancesSaysHowWellItFits) {
  auto list = distances(0.25, {0.5, 1, 2, 4}, 1, 0.03);
  list[1].distance *= 1.1;
  const auto fit = fit_order(0.25, list, 1);
  EXPECT_NEAR(fit->order, 1, 0.1);
  EXPECT_GT(fit->misfit, 0.01);
  EXPECT_LT(fit->misfit, 0.1);
}

TEST(ConvergenceOrder, IsNotToldWhereNothingConverges) {
  const std::vector<AxisDistance> falling{{1, 0.02}, {2, 0.01}};
  const auto fit = fit_order(0.5, falling, 1);
  EXPECT_EQ(fit->convergence, Convergence::not_monotone);
  EXPECT_EQ(fit->finest_error, 0.02);
}

TEST(ConvergenceOrder, OfRunsThatAgreeIsExact) {
  const std::vector<AxisDistance> rounded{{1, 3e-15}, {2, 1e-15}};
  EXPECT_EQ(fit_order(0.5, rounded, 1)->convergence, Convergence::exact);
  EXPECT_EQ(fit_order(0.5, rounded, 1)->finest_error, 0);
}

TEST(ConvergenceOrder, OfOneDistanceIsTheorys) {
  const auto fit = fit_order(0.5, distances(0.5, {1}, 2, 0.1), 2);
  EXPECT_EQ(fit->convergence, Convergence::order_assumed);
  EXPECT_NEAR(fit->finest_error, 0.025, 1e-12);
  EXPECT_FALSE(fit_order(0.5, {}, 2));
}

TEST(ConvergenceOrder, IsNoneWhereDistancesAreNoMoreThanRepeatsScatter) {
  const AxisDistance distances[] = {{1, 0.01}, {2, 0.03}};
  EXPECT_EQ(fit_order(0.5, distances, 1, 0.029)->convergence, Convergence::converging);
  const auto chance = fit_order(0.5, distances, 1, 0.03);
  ASSERT_TRUE(chance);
  EXPECT_EQ(chance->convergence, Convergence::within_scatter);
  EXPECT_EQ(chance->finest_error, 0.03) << "that it is less nobody knows";
}

}  // namespace
}  // namespace talus
