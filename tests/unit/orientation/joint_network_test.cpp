#include "orientation/joint_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "orientation/drawn_planes.hpp"
#include "orientation/mean_orientation.hpp"

namespace talus {
namespace {

Cut network(RadiusLaw law = RadiusLaw::equal, double density = 0.5) {
  Cut cut;
  cut.joint = "J1";
  cut.dip = 60;
  cut.dip_direction = 90;
  cut.network = JointNetwork{{{0, 10, -5}, {20, 40, 5}}, density, 0.7, law, {}};
  cut.through = {10, 25, 0};
  return cut;
}

double area_of(const Cut& disc) { return std::numbers::pi * disc.disc->radius * disc.disc->radius; }

TEST(JointNetwork, HasItsAreaToWithinOneDisc) {
  for (const RadiusLaw law : {RadiusLaw::equal, RadiusLaw::exponential, RadiusLaw::lognormal}) {
    const std::vector<Cut> discs = discs_of_network(network(law));
    double area = 0;
    for (const Cut& disc : discs) area += area_of(disc);
    EXPECT_GE(area, 0.5 * 20 * 30 * 10);
    EXPECT_LT(area - area_of(discs.back()), 0.5 * 20 * 30 * 10);
  }
}

TEST(JointNetwork, HasRadiiByTheirLaw) {
  const auto mean_and_deviation = [](RadiusLaw law) {
    double sum = 0, squares = 0;
    const std::vector<Cut> discs = discs_of_network(network(law, 5));
    for (const Cut& disc : discs) sum += disc.disc->radius, squares += disc.disc->radius * disc.disc->radius;
    const double n = static_cast<double>(discs.size());
    return std::pair(sum / n, std::sqrt(std::max(0.0, squares / n - sum / n * sum / n)));
  };
  EXPECT_NEAR(mean_and_deviation(RadiusLaw::equal).second, 0, 1e-6);
  EXPECT_NEAR(mean_and_deviation(RadiusLaw::exponential).first, 0.7, 0.02);
  EXPECT_NEAR(mean_and_deviation(RadiusLaw::exponential).second, 0.7, 0.04);
  EXPECT_NEAR(mean_and_deviation(RadiusLaw::lognormal).first, 0.7, 0.01);
  EXPECT_NEAR(mean_and_deviation(RadiusLaw::lognormal).second, 0.35, 0.01);
}

TEST(JointNetwork, HasCentresEvenlyInItsBox) {
  const std::vector<Cut> discs = discs_of_network(network(RadiusLaw::equal, 5));
  Vec3 sum = Vec3::Zero(), low = discs[0].disc->centre, high = low;
  for (const Cut& disc : discs) {
    sum += disc.disc->centre;
    low = low.cwiseMin(disc.disc->centre);
    high = high.cwiseMax(disc.disc->centre);
    EXPECT_EQ(disc.through, disc.disc->centre);
  }
  EXPECT_LT((sum / static_cast<double>(discs.size()) - Vec3(10, 25, 0)).norm(), 0.3);
  EXPECT_LT((low - Vec3(0, 10, -5)).norm(), 0.1);
  EXPECT_LT((high - Vec3(20, 40, 5)).norm(), 0.1);
  EXPECT_GE(low.x(), 0);
  EXPECT_LE(high.y(), 40);
}

TEST(JointNetwork, ScattersByKappaAndIsParallelWithout) {
  for (const Cut& disc : discs_of_network(network())) EXPECT_EQ(disc.dip, 60);
  Cut scattered = network(RadiusLaw::equal, 5);
  scattered.fisher_kappa = 80;
  std::vector<Vec3> poles;
  for (const Cut& disc : discs_of_network(scattered)) poles.push_back(pole_of({disc.dip, disc.dip_direction}));
  EXPECT_NEAR(fisher_mean(poles).kappa.value(), 80, 5);
}

TEST(JointNetwork, IsTheSameForItsSeedAndItsCentresForAnyScatter) {
  const Cut one = network();
  Cut other = one, scattered = one;
  EXPECT_EQ(discs_of_network(one), single_planes(one));
  EXPECT_TRUE(is_drawn(one));
  other.seed = 2;
  EXPECT_NE(discs_of_network(one), discs_of_network(other));
  scattered.fisher_kappa = 30;
  const std::vector<Cut> a = discs_of_network(one), b = discs_of_network(scattered);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].disc, b[i].disc);
}

}  // namespace
}  // namespace talus
