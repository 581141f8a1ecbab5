#include "effects/interior_contacts.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "effects/normal_contact.hpp"
#include "effects/shear_contact.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// How the corner of a rigid cube stands against a face of one of tetrahedra.
struct Case {
  std::string name;
  double gap;       ///< m
  double slip;      ///< m
  double friction;  ///< tan φ
};

class Interior : public testing::TestWithParam<Case> {
 protected:
  Interior()
      : system(test::block_system({test::box_block("lower", Vec3(0, 0, 0), Vec3(1, 1, 1)),
                                   test::box_block("upper", Vec3(0, 0, 1), Vec3(1, 1, 2), BodyKind::rigid)})),
        set(test::rock_project(30, {}), system) {
    set.mean_arms = true;
    ContactPoint point{};
    point.normal = Vec3(0.1, -0.2, 1).normalized();
    point.gap = GetParam().gap;
    point.size = 1;
    point.normal_stiffness = 3e9;
    point.shear_stiffness = 1.2e9;
    point.friction = GetParam().friction;
    point.multiplier = 2e4;
    if (point.friction > 0) point.shear_start = 4e3 * point.normal.cross(Vec3::UnitX()).normalized();
    point.stencil_end = 4;
    contacts.points = {point};
    contacts.nodes = {8, 4, 5, 6};
    contacts.weights = {1, -0.5, -0.3, -0.2};
    contacts.sort_out();
    links.connect();
    d = Increment::Zero(set.unknowns());
    const Vec3 slip = GetParam().slip * point.normal.cross(Vec3::UnitY()).normalized();
    d.segment<3>(3 * set.nodes.freedom[set.rigid[0].centre]) = slip;
    d[3 * set.rigid[0].rotation_freedom] = 1e-7;
    std::vector<std::pair<int, int>> couplings;
    for (int i = 0; i < set.unknowns() / 3; ++i)
      for (int j = 0; j < i; ++j) couplings.emplace_back(i, j);
    pattern = BlockPattern(set.unknowns() / 3, couplings);
  }
  Eigen::VectorXd still() const { return Eigen::VectorXd::Zero(d.size()); }
  /// Brings the products down to a share while the bodies stand still at D.
  InteriorContacts brought_down(double share) {
    InteriorContacts inside;
    inside.begin(links, d, still(), 1e6);
    const double least = share * inside.mean_product();
    for (int i = 0; i < 60 && inside.mean_product() > least; ++i) {
      inside.linearise(d);
      inside.aim_at_contact();
      inside.find_changes(d, d);
      inside.aim_at(0.1 * inside.mean_product());
      inside.find_changes(d, d);
      inside.change_by(inside.longest_share());
    }
    inside.linearise(d);
    inside.aim_at_contact();
    return inside;
  }

  BlockSystem system;
  BodySet set;
  ContactSet contacts;
  ContactLinks links{set, contacts};
  Increment d;
  BlockPattern pattern;
};

TEST_P(Interior, its_force_becomes_that_of_the_contacts_law) {
  NormalContact normal(links, NormalContact::Points::loose);
  ShearContact shear(links);
  shear.update_strength(d);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(d.size());
  normal.add_gradient(d, gradient);
  shear.add_gradient(d, gradient);
  const double scale = 1e-9 * 2e4;  // N
  brought_down(1e-10).add_forces(d, gradient);
  EXPECT_LT(gradient.norm(), scale);
}

TEST_P(Interior, its_tangent_becomes_that_of_the_contacts_law) {
  NormalContact normal(links, NormalContact::Points::loose);
  ShearContact shear(links);
  shear.update_strength(d);
  SymmetricBlocks of_law;
  UnsymmetricBlocks beyond_law, beyond_inside;
  of_law.set_pattern(pattern);
  beyond_law.set_pattern(pattern);
  beyond_inside.set_pattern(pattern);
  normal.add_hessian(d, of_law);
  normal.add_unsymmetric(d, beyond_law);
  shear.add_hessian(d, of_law);
  shear.add_unsymmetric(d, beyond_law);
  const InteriorContacts inside = brought_down(1e-7);  // beyond, rounding tells in sliding
  inside.add_tangent(d, beyond_inside);
  const Eigen::VectorXd way = Eigen::VectorXd::LinSpaced(d.size(), -1, 2);
  const double stiffness = contacts.points[0].normal_stiffness;
  Eigen::VectorXd by_law, by_inside = still();
  of_law.multiply(way, by_law);
  UnsymmetricBlocks::add_product(beyond_law.pairs(), way, by_law);
  UnsymmetricBlocks::add_product(beyond_inside.pairs(), way, by_inside);
  EXPECT_LT((by_inside - by_law).norm(), 1e-5 * stiffness);
}

TEST_P(Interior, products_come_down_together) {
  InteriorContacts inside;
  inside.begin(links, d, still(), 1e6);
  const double before = inside.mean_product();
  EXPECT_GT(before, 0);
  EXPECT_LT(brought_down(1e-10).mean_product(), 1e-10 * before);
}

TEST_P(Interior, points_that_cannot_come_to_bear_stay_out) {
  contacts.points[0].gap = 0.1;
  Eigen::VectorXd flight = still();
  InteriorContacts inside;
  inside.begin(links, d, flight, 1e6);
  EXPECT_EQ(inside.size(), 0);
  Eigen::Ref<Vec3> fall = flight.segment<3>(3 * set.nodes.freedom[set.rigid[0].centre]);
  fall.z() = -0.06;
  inside.begin(links, d, flight, 1e6);
  EXPECT_EQ(inside.size(), 0);
  fall.z() = -0.12;
  inside.begin(links, d, flight, 1e6);
  EXPECT_EQ(inside.size(), 1);
  fall.z() = 0.12;
  inside.begin(links, d, flight, 1e6);
  EXPECT_EQ(inside.size(), 0);
}

INSTANTIATE_TEST_SUITE_P(InteriorContacts, Interior,
                         testing::Values(Case{"open", 5e-4, 1e-3, 0.5}, Case{"sticks", -1e-5, 2e-6, 0.5},
                                         Case{"slides", -1e-5, 1e-3, 0.5}, Case{"slides_smoothly", -1e-5, 1e-3, 0}),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace talus
