// Effects on rigid and affine bodies: the tangent against differences of the gradient, along BodySet::advance.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "bodies/consistent_mass.hpp"
#include "bodies/finite_rotation.hpp"
#include "effects/body_force.hpp"
#include "effects/corotational_elasticity.hpp"
#include "effects/damping.hpp"
#include "effects/displacement_constraint.hpp"
#include "effects/inertia.hpp"
#include "effects/normal_contact.hpp"
#include "effects/point_load.hpp"
#include "effects/shear_contact.hpp"
#include "support/one_block.hpp"

namespace talus {
namespace {

/// A rigid block on an affine one, both turned before, in the middle of a step that turns them further.
class SingleBodyDerivatives : public testing::Test {
 protected:
  explicit SingleBodyDerivatives(BodyKind lower = BodyKind::affine)
      : set_(project(), system(lower)), d_(set_.unknowns()) {
    for (int i = 0; i < d_.size(); ++i) d_[i] = 0.02 * std::sin(7.0 * i + 1);
    for (std::size_t i = 0; i < set_.nodes.velocity.size(); ++i) {
      set_.nodes.velocity[i] = Vec3(0.1 * double(i), 0.2, -0.3);
      set_.nodes.acceleration[i] = Vec3(3, -double(i), 0.5);
    }
    set_.rigid[0].angular_momentum = Vec3(300, -500, 800);
    set_.rigid[0].moment = Vec3(-100, 200, 50);
    set_.move(20 * d_);
  }
  static Project project() {
    Project project;
    project.materials = {{"rock", 2600, 5e9, 0.24}};
    return project;
  }
  static BlockSystem system(BodyKind lower = BodyKind::affine) {
    BlockSystem system;
    system.blocks = {test::box_block("lower", Vec3(0, 0, 0), Vec3(2, 1.5, 1), lower),
                     test::box_block("upper", Vec3(0.2, 0.1, 1), Vec3(1.2, 1.3, 2.1), BodyKind::rigid)};
    return system;
  }
  MaterialPoint inside() const { return material_point(system(), "upper", Vec3(0.6, 0.5, 1.4), 0, "/loads/0"); }

  /// Hessian and unsymmetric part, against central differences of `gradient_at` along BodySet::advance.
  template <class GradientAt>
  void expect_tangent(const Effect& effect, const GradientAt& gradient_at, double tolerance,
                      Arms arms = Arms::end) const {
    const auto n = d_.size();
    std::vector<std::pair<int, int>> couplings;
    for (int i = 0; i < n / 3; ++i)
      for (int j = 0; j < i; ++j) couplings.emplace_back(i, j);
    SymmetricBlocks hessian;
    hessian.set_pattern(static_cast<int>(n / 3), couplings);
    UnsymmetricBlocks unsymmetric;
    unsymmetric.set_pattern(hessian.pattern());
    effect.add_hessian(d_, hessian);
    effect.add_unsymmetric(d_, arms, unsymmetric);
    Eigen::MatrixXd tangent(n, n), differences(n, n);
    constexpr double step = 1e-6;
    Eigen::VectorXd column;
    Increment plus, minus;
    for (int i = 0; i < n; ++i) {
      hessian.multiply(Eigen::VectorXd::Unit(n, i), column);
      UnsymmetricBlocks::add_product(unsymmetric.pairs(), Eigen::VectorXd::Unit(n, i), column);
      tangent.col(i) = column;
      set_.advance(d_, step * Eigen::VectorXd::Unit(n, i), plus);
      set_.advance(d_, -step * Eigen::VectorXd::Unit(n, i), minus);
      differences.col(i) = (gradient_at(plus) - gradient_at(minus)) / (2 * step);
    }
    EXPECT_GT(differences.cwiseAbs().maxCoeff(), 0) << to_string(effect.kind()) << ": the comparison would be empty";
    EXPECT_LT((differences - tangent).cwiseAbs().maxCoeff(), tolerance * differences.cwiseAbs().maxCoeff())
        << to_string(effect.kind());
  }
  void expect_tangent(const Effect& effect, double tolerance) const {
    expect_tangent(
        effect, [&](const Increment& d) { return gradient(effect, d); }, tolerance);
  }
  static Eigen::VectorXd gradient(const Effect& effect, const Increment& d, Arms arms = Arms::end) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(d.size());
    effect.add_gradient(d, arms, sum);
    return sum;
  }

  BodySet set_;
  Increment d_;
};

TEST_F(SingleBodyDerivatives, Inertia) {
  Inertia inertia(set_);
  for (const TimeIntegration& integration : {TimeIntegration::newmark(), TimeIntegration::constant_acceleration(),
                                             TimeIntegration::generalized_alpha(0.3)}) {
    inertia.begin_step({0, 0.01, 1, integration});
    expect_tangent(inertia, 1e-7);
  }
}

TEST_F(SingleBodyDerivatives, Damping) {
  Damping damping(set_, {0.4, 0.9});
  damping.begin_step({0, 0.02, 1});
  expect_tangent(damping, 1e-7);
}

TEST_F(SingleBodyDerivatives, CorotationalElasticityOfTheAffineBlock) {
  expect_tangent(CorotationalElasticity(set_), 1e-3);  // its Hessian leaves out what is negative
}

TEST_F(SingleBodyDerivatives, GravityIsTheWeightAtTheCentroids) {
  const Eigen::VectorXd force = gradient(BodyForce(set_, Vec3(0, 0, -10)), d_);
  double sum = 0;
  for (const int n : set_.nodes.free) sum += force[3 * set_.nodes.dof_block[n] + 2];
  EXPECT_NEAR(sum, 10 * 2600 * (3 + 1.32), 1e-8);
  EXPECT_EQ(force.segment<3>(3 * set_.rigid[0].rotation_dof_block).norm(), 0);
}

TEST_F(SingleBodyDerivatives, ALoadOutOfTheCentroidTurnsTheRigidBlock) {
  PointLoads loads(set_, {{inside(), Vec3(1e4, 2e4, -3e4)}});
  loads.begin_step({});
  expect_tangent(loads, 1e-7);
  const Vec3 arm = inside().at(set_.nodes.position) - set_.nodes.position[set_.rigid[0].centre];
  const Eigen::VectorXd force = gradient(loads, Increment::Zero(d_.size()));
  const Vec3 moment = set_.rigid[0].radius * force.segment<3>(3 * set_.rigid[0].rotation_dof_block);
  EXPECT_LT((moment + arm.cross(Vec3(1e4, 2e4, -3e4))).norm(), 1e-9);
}

TEST_F(SingleBodyDerivatives, AForceDoesTheWorkOfItsDisplacementWithMeanArms) {
  const Vec3 force(3e4, -2e4, 5e4);
  PointLoads load(set_, {{inside(), force}});
  load.begin_step({});
  const RigidBody& rigid = set_.rigid[0];
  d_.segment<3>(3 * rigid.rotation_dof_block) = rigid.radius * Vec3(0.3, -0.2, 0.4);
  const Vec3 before = inside().at(set_.nodes.position);
  const double work = -gradient(load, d_, Arms::mean).dot(d_);
  set_.move(d_);
  EXPECT_NEAR(work, force.dot(inside().at(set_.nodes.position) - before), 1e-9 * std::abs(work));
}

TEST_F(SingleBodyDerivatives, DisplacementConstraint) {
  DisplacementConstraints constraints(set_, {{inside(), {{0.01, std::nullopt, -0.02}}, 1e9}});
  constraints.begin_step({});
  expect_tangent(constraints, 1e-7);
}

/// Corners of the upper block against a point of the lower block, deep in penetration at the increment.
struct Touching {
  Touching(const BodySet& set, const Increment& d, double friction, Arms arms = Arms::end,
           const std::vector<int>& corners = {8})
      : links(set, contacts) {
    for (const int corner : corners) {
      ContactPoint point{};
      point.normal = Vec3(0.1 * (corner - 7), -0.2, 1).normalized();
      point.normal_stiffness = 3e9;
      point.shear_stiffness = 1.2e9;
      point.friction = friction;
      point.stencil_begin = static_cast<int>(contacts.nodes.size());
      point.stencil_end = point.stencil_begin + 4;
      contacts.points.push_back(point);
      contacts.nodes.insert(contacts.nodes.end(), {corner, 4, 5, 6});
      contacts.weights.insert(contacts.weights.end(), {1, -0.5, -0.2, -0.3});
    }
    contacts.sort_out();
    links.connect(arms);
    for (int i = 0; i < links.moves().size(); ++i)
      contacts.points[i].gap = -0.01 - contacts.points[i].normal.dot(links.moves().increment(i, d));
  }
  ContactSet contacts;
  ContactLinks links;
};

TEST_F(SingleBodyDerivatives, ContactInStickAndInSlip) {
  for (const double friction : {0.05, 50.0}) {
    const Touching touching(set_, d_, friction);
    expect_tangent(NormalContact(touching.links, NormalContact::Points::loose), 1e-7);
    ShearContact shear(touching.links);
    const auto gradient_at = [&](const Increment& d) {
      shear.update_strength(d);
      return gradient(shear, d);
    };
    gradient_at(d_);
    const bool slides = shear.slip(0, d_) > 0;
    EXPECT_EQ(slides, friction < 1) << shear.spring_force(0, d_).norm() << " N of " << shear.strength(0);
    expect_tangent(shear, gradient_at, 1e-6);
  }
}

/// With mean arms the tangent leaves out how their stretch changes, a sixth of the angle; the rest of what a load or a
/// spring adds is there, which is half of the load's tangent.
TEST_F(SingleBodyDerivatives, TangentsOfContactsAndLoadsKnowMeanArms) {
  d_ *= 0.25;
  const auto expect_tangent_with_mean_arms = [&](const Effect& effect, double tolerance) {
    expect_tangent(
        effect, [&](const Increment& d) { return gradient(effect, d, Arms::mean); }, tolerance, Arms::mean);
  };
  const Touching touching(set_, d_, 0.5);
  expect_tangent_with_mean_arms(NormalContact(touching.links, NormalContact::Points::loose), 1e-3);
  PointLoads load(set_, {{inside(), Vec3(1e4, 2e4, -3e4)}});
  load.begin_step({});
  expect_tangent_with_mean_arms(load, 1e-2);
}

/// Two rigid blocks, which meet at one place.
class MeetingDerivatives : public SingleBodyDerivatives {
 protected:
  MeetingDerivatives() : SingleBodyDerivatives(BodyKind::rigid) {
    for (RigidBody& rigid : set_.rigid) rigid.touches = true;
    d_ *= 0.25;
  }
};

TEST_F(MeetingDerivatives, TangentsOfContactsAtOneAndAtMorePlaces) {
  for (const auto& [friction, corners] : std::initializer_list<std::pair<double, std::vector<int>>>{
           {0.05, {8}}, {50, {8}}, {0.05, {8, 9, 10}}, {50, {8, 9, 10}}}) {
    const Touching touching(set_, d_, friction, Arms::mean, corners);
    const NormalContact normal(touching.links, NormalContact::Points::loose);
    expect_tangent(
        normal, [&](const Increment& d) { return gradient(normal, d, Arms::mean); }, 1e-6, Arms::mean);
    ShearContact shear(touching.links);
    const auto gradient_at = [&](const Increment& d) {
      shear.update_strength(d);
      return gradient(shear, d, Arms::mean);
    };
    gradient_at(d_);
    ASSERT_EQ(shear.slip(0, d_) > 0, friction < 1);
    expect_tangent(shear, gradient_at, 1e-6, Arms::mean);
  }
}

TEST_F(MeetingDerivatives, Inertia) {
  talus::Inertia inertia(set_);
  inertia.begin_step({0, 0.01, 1, TimeIntegration::newmark()});
  expect_tangent(inertia, 1e-7);
}

TEST_F(MeetingDerivatives, ForcesHaveAPotentialWithArmsAtTheEnd) {
  const Touching touching(set_, d_, 0.5, Arms::mean);
  const NormalContact normal(touching.links, NormalContact::Points::loose);
  const Eigen::VectorXd gradient_there = gradient(normal, d_);
  constexpr double step = 1e-6;
  Increment plus, minus;
  for (int i = 0; i < d_.size(); ++i) {
    set_.advance(d_, step * Eigen::VectorXd::Unit(d_.size(), i), plus);
    set_.advance(d_, -step * Eigen::VectorXd::Unit(d_.size(), i), minus);
    EXPECT_NEAR((normal.energy(plus) - normal.energy(minus)) / (2 * step), gradient_there[i],
                1e-6 * gradient_there.norm());
  }
}

/// Moments about one place; and the work of a force is that of its displacement, also where they slide.
TEST_F(MeetingDerivatives, ForcesKeepAngularMomentumAndDoTheirWork) {
  const Touching touching(set_, d_, 0.5, Arms::mean);
  const Attachments& moves = touching.links.moves();
  const Vec3 force(3e4, -2e4, 5e4);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(d_.size());
  moves.add_force(0, d_, force, Arms::mean, sum);
  Vec3 moments = Vec3::Zero();
  double work = 0;
  for (const RigidBody& rigid : set_.rigid) {
    const Vec3 on_centre = sum.segment<3>(3 * set_.nodes.dof_block[rigid.centre]),
               moment = rigid.radius * sum.segment<3>(3 * rigid.rotation_dof_block),
               moved = d_.segment<3>(3 * set_.nodes.dof_block[rigid.centre]);
    moments += (set_.nodes.position[rigid.centre] + 0.5 * moved).cross(on_centre) + moment;
    work += on_centre.dot(moved) + moment.dot(cayley_vector(rigid.theta(d_)));
  }
  EXPECT_LT(moments.norm(), 1e-10 * force.norm());
  EXPECT_NEAR(work, force.dot(moves.increment(0, d_)), 1e-10 * std::abs(work));
}

using test::one_block;

double mass_square(const BodySet& set, const std::vector<Vec3>& velocity) {
  double sum = 0;
  for (const Element& element : set.elements) {
    Corners corners;
    for (int i = 0; i < 4; ++i) corners[i] = velocity[element.nodes[i]];
    sum += talus::mass_square(element.mass, corners);
  }
  return sum;
}

TEST(SingleBodyMass, AnAffineBodyHasTheMassOfItsTetrahedra) {
  const BodySet fine = one_block(BodyKind::tetrahedra), affine = one_block(BodyKind::affine);
  ASSERT_EQ(affine.unknowns(), 12);
  const auto field = [](const Vec3& x) {
    Mat3 slope;
    slope << 0.2, -1, 0.3, 2, 0.5, -0.7, 0.1, 0.4, 1.5;
    return Vec3(slope * x + Vec3(1, -2, 0.5));
  };
  std::vector<Vec3> of_fine, of_affine;
  for (const Vec3& x : fine.nodes.reference) of_fine.push_back(field(x));
  for (const Vec3& x : affine.nodes.reference) of_affine.push_back(field(x));
  const double expected = mass_square(fine, of_fine);
  EXPECT_NEAR(mass_square(affine, of_affine), expected, 1e-12 * expected);
  EXPECT_NEAR(affine.shapes[0].volume, 1, 1e-14);
}

}  // namespace
}  // namespace talus
