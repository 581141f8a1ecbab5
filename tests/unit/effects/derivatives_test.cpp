// Every effect's gradient and Hessian against finite differences of its energy and gradient.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "effects/body_force.hpp"
#include "effects/corotational_elasticity.hpp"
#include "effects/damping.hpp"
#include "effects/displacement_constraint.hpp"
#include "effects/elasticity.hpp"
#include "effects/in_situ_stress.hpp"
#include "effects/inertia.hpp"
#include "effects/initial_stress.hpp"
#include "effects/normal_contact.hpp"
#include "effects/point_load.hpp"
#include "effects/shear_contact.hpp"
#include "support/dense_matrix.hpp"
#include "support/finite_differences.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

class Derivatives : public testing::Test {
 protected:
  Derivatives() : set_(project(), system()), d_(set_.unknowns()) {
    for (int i = 0; i < d_.size(); ++i) d_[i] = 1e-3 * std::sin(7.0 * i + 1);  // no symmetry, reproducible
    for (std::size_t i = 0; i < set_.nodes.velocity.size(); ++i) {
      set_.nodes.velocity[i] = Vec3(0.1 * double(i), 0.2, -0.3);
      set_.nodes.acceleration[i] = Vec3(3, -double(i), 0.5);
    }
    for (std::size_t e = 0; e < set_.stress.size(); ++e) set_.stress[e] << 1e5, -2e5, 3e5, 4e4, 5e4 * double(e), -6e4;
  }
  static Project project() {
    Project project;
    project.materials = {{"rock", 2600, 5e9, 0.24}};
    return project;
  }
  static BlockSystem system() {
    BlockSystem system;
    system.blocks = {test::box_block("lower", Vec3(0, 0, 0), Vec3(2, 1.5, 1)),
                     test::box_block("upper", Vec3(0.2, 0.1, 1), Vec3(1.2, 1.3, 2.1))};
    return system;
  }
  /// A point of the upper block's bottom against one of the lower block's top.
  ContactSet contact(double gap) const {
    ContactSet contacts;
    ContactPoint point{};
    point.normal = Vec3(0.1, -0.2, 1).normalized();
    point.gap = gap;
    point.normal_stiffness = 3e9;
    point.shear_stiffness = 1.2e9;
    point.friction = 0.5;
    point.stencil_end = 4;
    contacts.points = {point};
    contacts.nodes = {8, 4, 5, 6};
    contacts.weights = {1, -0.5, -0.2, -0.3};
    return contacts;
  }
  /// Contact effects of a set that is done.
  struct Touching {
    Touching(const BodySet& set, ContactSet given) : contacts(std::move(given)), links(set, contacts) {
      contacts.sort_out();
      links.connect();
    }
    ContactSet contacts;
    ContactLinks links;
    NormalContact normal{links, NormalContact::Points::loose};
    NormalContact bonds{links, NormalContact::Points::bonded};
    ShearContact shear{links};
  };
  MaterialPoint inside() const { return material_point(system(), "upper", Vec3(0.6, 0.5, 1.4), 0, "/loads/0"); }

  /// Turns the blocks and stretches them by more than the increment can take back (less than one: squeezes them).
  void turn_and_stretch(double stretch) {
    const Mat3 rotation = Eigen::AngleAxisd(0.8, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    for (Vec3& x : set_.nodes.position) x = rotation * Vec3(stretch * x.x(), 1.02 * stretch * x.y(), stretch * x.z());
  }

  BodySet set_;
  Increment d_;
};

Eigen::MatrixXd hessian_of(const Effect& effect, const BodySet& set, const Increment& d) {
  SymmetricBlocks hessian;
  std::vector<std::pair<int, int>> couplings;
  effect.add_couplings(couplings);
  hessian.set_pattern(set.nodes.movable, couplings);
  effect.add_hessian(d, hessian);
  return test::dense_matrix(hessian, d.size());
}

TEST_F(Derivatives, Elasticity) { test::expect_derivatives(Elasticity(set_), d_, 1e-4, 1e-8); }

TEST_F(Derivatives, CorotationalElasticityOfTurnedAndStretchedBlocks) {
  turn_and_stretch(1.2);
  test::expect_derivatives(CorotationalElasticity(set_), d_, 1e-5, 1e-7);
}

TEST_F(Derivatives, CorotationalElasticityOfSqueezedBlocksLeavesOutWhatIsNegative) {
  turn_and_stretch(0.8);
  EXPECT_TRUE(test::has_no_negative_eigenvalue(hessian_of(CorotationalElasticity(set_), set_, d_)));
}

TEST_F(Derivatives, CorotationalElasticityKeepsItsStiffnessWhileLittleChanges) {
  const CorotationalElasticity elasticity(set_);
  const Eigen::MatrixXd before = hessian_of(elasticity, set_, d_);
  EXPECT_EQ(hessian_of(elasticity, set_, (1 + 1e-5) * d_), before);
  EXPECT_EQ(hessian_of(elasticity, set_, 2 * d_), hessian_of(CorotationalElasticity(set_), set_, 2 * d_));
}

TEST_F(Derivatives, CorotationalElasticityHasTheSameForcesWhateverItWasAskedBefore) {
  const auto forces = [&](const CorotationalElasticity& elasticity, double times) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(d_.size());
    elasticity.add_gradient(times * d_, Arms::end, sum);
    return sum;
  };
  const CorotationalElasticity elasticity(set_);
  for (const double times : {1.0, 1.0, 2.0, 0.0, 1.0})
    EXPECT_EQ(forces(elasticity, times), forces(CorotationalElasticity(set_), times)) << times;
}

/// A step in which the blocks only turn, by 0.05 rad.
Increment turning(const BodySet& set) {
  const Mat3 rotation = Eigen::AngleAxisd(0.05, Vec3(2, -1, 1).normalized()).toRotationMatrix();
  Increment d(set.unknowns());
  for (const int n : set.nodes.free)
    d.segment<3>(3 * set.nodes.dof_block[n]) = (rotation - Mat3::Identity()) * set.nodes.position[n];
  return d;
}

TEST_F(Derivatives, CorotationalElasticityOfBlocksThatTurnInTheStep) {
  turn_and_stretch(0.8);
  CorotationalElasticity elasticity(set_);
  elasticity.begin_step({0, 0.01, 1});
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(d_.size(), -1, 1.5);
  test::expect_tangent_along(elasticity, turning(set_) + d_, x, 1e-6, 1e-7);
}

/// The work of its forces along a step in which the blocks only turn.
double work_of_turning(const Effect& effect, const BodySet& set) {
  const Increment d = turning(set);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(d.size());
  effect.add_gradient(d, Arms::end, gradient);
  return gradient.dot(d);
}

TEST_F(Derivatives, StressedRockThatTurnsDoesNoWork) {
  Project project = Derivatives::project();
  project.in_situ.emplace_back();
  project.in_situ[0].stress << 3e6, 2e6, 4e6, 5e5, -4e5, 2e5;
  turn_and_stretch(1.05);
  CorotationalElasticity elasticity(set_);
  InSituStresses in_situ(project, system(), set_);
  for (Effect* effect : std::initializer_list<Effect*>{&elasticity, &in_situ}) {
    const double at_the_end = work_of_turning(*effect, set_);
    effect->begin_step({0, 0.01, 1});
    EXPECT_LT(std::abs(work_of_turning(*effect, set_)), 1e-9 * std::abs(at_the_end)) << to_string(effect->kind());
  }
}

TEST_F(Derivatives, InSituStressThatPulls) {
  Project project = Derivatives::project();
  project.in_situ.emplace_back();
  project.in_situ[0].stress << 3e6, 2e6, 4e6, 5e5, -4e5, 2e5;
  project.in_situ[0].gradient << 1e5, 0, 2e5, 0, 0, 0;
  turn_and_stretch(1.1);
  test::expect_derivatives(InSituStresses(project, system(), set_), d_, 1e-4, 1e-8);
}

TEST_F(Derivatives, Damping) {
  Damping damping(set_, {0.4, 0.9});
  damping.begin_step({0, 0.02, 1});
  test::expect_derivatives(damping, d_, 1e-4, 1e-8);
}

TEST_F(Derivatives, InitialStress) { test::expect_derivatives(InitialStress(set_), d_, 1e-4, 1e-8); }

TEST_F(Derivatives, InertiaOfEveryIntegrator) {
  Inertia inertia(set_);
  for (const TimeIntegration& integration : {TimeIntegration::newmark(), TimeIntegration::constant_acceleration(),
                                             TimeIntegration::generalized_alpha(0.3)}) {
    inertia.begin_step({0, 0.01, 1, integration});
    test::expect_derivatives(inertia, d_, 1e-4, 1e-8);
  }
}

TEST_F(Derivatives, BodyForce) { test::expect_derivatives(BodyForce(set_, Vec3(1, -2, -9.81)), d_, 1e-4, 1e-8); }

TEST_F(Derivatives, PointLoad) {
  PointLoads loads(set_, {{inside(), Vec3(1e4, 2e4, -3e4)}});
  loads.begin_step({});
  test::expect_derivatives(loads, d_, 1e-4, 1e-8);
}

TEST_F(Derivatives, DisplacementConstraintWithAFreeComponent) {
  DisplacementConstraints constraints(set_, {{inside(), {{0.01, std::nullopt, -0.02}}, 1e9}});
  constraints.begin_step({});
  test::expect_derivatives(constraints, d_, 1e-4, 1e-8);
}

TEST_F(Derivatives, NormalContactInPenetration) {
  test::expect_derivatives(Touching(set_, contact(-0.0015)).normal, d_, 1e-4, 1e-8);
}

TEST_F(Derivatives, NormalContactOfABondInTensionAndAtItsStrength) {
  ContactSet contacts = contact(0.01);
  contacts.points[0].bonded = true;
  contacts.points[0].tension = 1e9;
  test::expect_derivatives(Touching(set_, contacts).bonds, d_, 1e-4, 1e-8);
  contacts.points[0].tension = 1e6;
  test::expect_derivatives(Touching(set_, contacts).bonds, d_, 1e-4, 1e-8);
}

TEST_F(Derivatives, OpenContactExertsNothing) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(d_.size());
  Touching(set_, contact(0.02)).normal.add_gradient(d_, Arms::end, gradient);
  EXPECT_EQ(gradient.norm(), 0);
}

TEST_F(Derivatives, ShearContactSticking) {
  ContactSet contacts = contact(-0.05);
  contacts.points[0].shear_start = Vec3(1e5, 0, 0) - contacts.points[0].normal * 1e5 * contacts.points[0].normal.x();
  Touching touching(set_, contacts);
  ShearContact& shear = touching.shear;
  shear.update_strength(d_);
  ASSERT_LT(shear.force_at(0, d_).norm(), shear.strength(0));
  test::expect_derivatives(shear, d_, 1e-5, 1e-7);
}

TEST_F(Derivatives, ShearContactSliding) {
  const ContactSet contacts = contact(-0.001);
  Touching touching(set_, contacts);
  ShearContact& shear = touching.shear;
  shear.update_strength(d_);
  ASSERT_GT(shear.strength(0), 0);
  ASSERT_NEAR(shear.force_at(0, d_).norm(), shear.strength(0), 1e-9 * shear.strength(0));
  test::expect_derivatives(shear, d_, 1e-6, 1e-6);
}

TEST_F(Derivatives, ContactHeldInAState) {
  for (const double gap : {-0.05, 0.02}) {  // whether it is closed or open there
    Touching touching(set_, contact(gap));
    touching.shear.update_strength(d_);
    std::vector<HeldContact> held(1);
    held[0].closed = true;
    held[0].friction = touching.contacts.points[0].normal.unitOrthogonal() * 1e6;
    held[0].across = 0.4;
    touching.normal.hold(&held);
    touching.shear.hold(&held);
    test::expect_derivatives(touching.normal, d_, 1e-4, 1e-8);
    for (const ContactMode shear : {ContactMode::stick, ContactMode::slip}) {
      held[0].shear = shear;
      test::expect_derivatives(touching.shear, d_, 1e-4, 1e-8);
    }
    held[0] = {};
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(d_.size());
    touching.normal.add_gradient(d_, Arms::end, gradient);
    touching.shear.add_gradient(d_, Arms::end, gradient);
    EXPECT_EQ(gradient.norm(), 0) << "it is held open";
  }
}

TEST_F(Derivatives, NormalContactWithAMultiplier) {
  ContactSet contacts = contact(0.004);
  contacts.points[0].multiplier = 5e7;
  test::expect_derivatives(Touching(set_, contacts).normal, d_, 1e-4, 1e-8);
}

TEST_F(Derivatives, TangentOfSlidingKnowsThatStrengthFollowsTheNormalForce) {
  const ContactSet contacts = contact(-0.0015);
  Touching touching(set_, contacts);
  ShearContact& shear = touching.shear;
  const auto gradient = [&](const Increment& d) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(d.size());
    shear.update_strength(d);
    shear.add_gradient(d, Arms::end, sum);
    return sum;
  };
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(d_.size(), -1, 1.5);
  constexpr double step = 1e-6;
  const Eigen::VectorXd slope = (gradient(d_ + step * x) - gradient(d_ - step * x)) / (2 * step);
  shear.update_strength(d_);
  ASSERT_GT(shear.strength(0), 0) << "it is open";
  ASSERT_GT(shear.spring_force(0, d_).norm(), 1.01 * shear.strength(0)) << "it does not slide";
  std::vector<std::pair<int, int>> couplings;
  for (int i = 0; i < set_.nodes.movable; ++i)
    for (int j = 0; j < i; ++j) couplings.emplace_back(i, j);
  SymmetricBlocks hessian;
  hessian.set_pattern(set_.nodes.movable, couplings);
  shear.add_hessian(d_, hessian);
  Eigen::VectorXd symmetric;
  hessian.multiply(x, symmetric);
  Eigen::VectorXd tangent = symmetric;
  UnsymmetricBlocks unsymmetric;
  unsymmetric.set_pattern(hessian.pattern());
  shear.add_unsymmetric(d_, Arms::end, unsymmetric);
  UnsymmetricBlocks::add_product(unsymmetric.pairs(), x, tangent);
  EXPECT_LT((tangent - slope).norm(), 1e-6 * slope.norm());
  EXPECT_GT((symmetric - slope).norm(), 0.01 * slope.norm()) << "the unsymmetric part adds nothing here";
}

TEST_F(Derivatives, ATurnedBlockHasNoCorotationalStressAndATurnedStressInSituNoMoment) {
  const Mat3 rotation = Eigen::AngleAxisd(2.5, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  for (Vec3& x : set_.nodes.position) x = rotation * x;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(d_.size());
  CorotationalElasticity(set_).add_gradient(Increment::Zero(d_.size()), Arms::end, force);
  EXPECT_LT(force.norm(), 1e-5);  // N, of a stiffness of 5e9 N/m

  Project project = Derivatives::project();
  project.in_situ.emplace_back();
  project.in_situ[0].stress << 3e6, 2e6, -4e6, 5e5, -4e5, 2e5;
  force.setZero();
  InSituStresses(project, system(), set_).add_gradient(Increment::Zero(d_.size()), Arms::end, force);
  Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
  for (int n = 0; n < set_.nodes.movable; ++n) {
    sum += force.segment<3>(3 * n);
    moment += set_.nodes.position[n].cross(force.segment<3>(3 * n));
  }
  EXPECT_LT(sum.norm() + moment.norm(), 1e-11 * force.norm());
}

}  // namespace
}  // namespace talus
