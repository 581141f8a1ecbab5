#include "solve/equilibrium/interior_point_contacts.hpp"

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
    d.segment<3>(3 * set.nodes.dof_block[set.rigid[0].centre]) = slip;
    d[3 * set.rigid[0].rotation_dof_block] = 1e-7;
    std::vector<std::pair<int, int>> couplings;
    for (int i = 0; i < set.unknowns() / 3; ++i)
      for (int j = 0; j < i; ++j) couplings.emplace_back(i, j);
    pattern = BlockPattern(set.unknowns() / 3, couplings);
  }
  Eigen::VectorXd still() const { return Eigen::VectorXd::Zero(d.size()); }
  /// Brings the complementarity down to a fraction while the bodies stand still at D.
  InteriorPointContacts brought_down(double fraction) {
    InteriorPointContacts interior;
    interior.begin(links, contacts.loose, d, still(), d, 1e6);
    const double least = fraction * interior.mean_complementarity();
    for (int i = 0; i < 60 && interior.mean_complementarity() > least; ++i) {
      interior.linearise(d);
      interior.target_contact();
      interior.find_changes(d, d);
      interior.target_complementarity(0.1 * interior.mean_complementarity());
      interior.find_changes(d, d);
      interior.change_by(interior.longest_step_fraction());
    }
    interior.linearise(d);
    interior.target_contact();
    return interior;
  }

  BlockSystem system;
  BodySet set;
  ContactSet contacts;
  ContactLinks links{set, contacts};
  Increment d;
  BlockPattern pattern;
};

TEST_P(Interior, ForceBecomesThatOfTheContactLaw) {
  NormalContact normal(links, NormalContact::Points::loose);
  ShearContact shear(links);
  shear.update_strength(d);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(d.size());
  normal.add_gradient(d, Arms::mean, gradient);
  shear.add_gradient(d, Arms::mean, gradient);
  const double scale = 1e-9 * 2e4;  // N
  brought_down(1e-10).add_forces(d, Arms::mean, gradient);
  EXPECT_LT(gradient.norm(), scale);
}

TEST_P(Interior, TangentBecomesThatOfTheContactLaw) {
  NormalContact normal(links, NormalContact::Points::loose);
  ShearContact shear(links);
  shear.update_strength(d);
  SymmetricBlocks of_law;
  UnsymmetricBlocks unsymmetric_law, unsymmetric_interior;
  of_law.set_pattern(pattern);
  unsymmetric_law.set_pattern(pattern);
  unsymmetric_interior.set_pattern(pattern);
  normal.add_hessian(d, of_law);
  normal.add_unsymmetric(d, Arms::mean, unsymmetric_law);
  shear.add_hessian(d, of_law);
  shear.add_unsymmetric(d, Arms::mean, unsymmetric_law);
  const InteriorPointContacts interior = brought_down(1e-7);  // below, rounding shows in sliding
  interior.add_tangent(d, Arms::mean, unsymmetric_interior);
  const Eigen::VectorXd change = Eigen::VectorXd::LinSpaced(d.size(), -1, 2);
  const double stiffness = contacts.points[0].normal_stiffness;
  Eigen::VectorXd by_law, by_interior = still();
  of_law.multiply(change, by_law);
  UnsymmetricBlocks::add_product(unsymmetric_law.pairs(), change, by_law);
  UnsymmetricBlocks::add_product(unsymmetric_interior.pairs(), change, by_interior);
  EXPECT_LT((by_interior - by_law).norm(), 1e-5 * stiffness);
}

TEST_P(Interior, ComplementarityComesDownToZero) {
  InteriorPointContacts interior;
  interior.begin(links, contacts.loose, d, still(), d, 1e6);
  const double before = interior.mean_complementarity();
  EXPECT_GT(before, 0);
  EXPECT_LT(brought_down(1e-10).mean_complementarity(), 1e-10 * before);
}

TEST_P(Interior, PointsThatCannotComeToBearTakeNoPart) {
  contacts.points[0].gap = 0.1;
  Eigen::VectorXd flight = still();
  InteriorPointContacts interior;
  interior.begin(links, contacts.loose, d, flight, d + flight, 1e6);
  EXPECT_EQ(interior.size(), 0);
  Eigen::Ref<Vec3> fall = flight.segment<3>(3 * set.nodes.dof_block[set.rigid[0].centre]);
  fall.z() = -0.06;
  interior.begin(links, contacts.loose, d, flight, d + flight, 1e6);
  EXPECT_EQ(interior.size(), 0);
  fall.z() = -0.12;
  interior.begin(links, contacts.loose, d, flight, d + flight, 1e6);
  EXPECT_EQ(interior.size(), 1);
  fall.z() = 0.12;
  interior.begin(links, contacts.loose, d, flight, d + flight, 1e6);
  EXPECT_EQ(interior.size(), 0);
}

INSTANTIATE_TEST_SUITE_P(InteriorPointContacts, Interior,
                         testing::Values(Case{"open", 5e-4, 1e-3, 0.5}, Case{"sticks", -1e-5, 2e-6, 0.5},
                                         Case{"slides", -1e-5, 1e-3, 0.5}, Case{"slides_smoothly", -1e-5, 1e-3, 0}),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace talus
