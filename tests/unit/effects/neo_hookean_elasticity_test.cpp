#include "effects/neo_hookean_elasticity.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "bodies/deformation.hpp"
#include "effects/corotational_elasticity.hpp"
#include "support/dense_matrix.hpp"
#include "support/finite_differences.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

/// A block of six tetrahedra and an affine one, of the same soft rock.
class NeoHookean : public testing::Test {
 protected:
  NeoHookean() : set_(project(), system()), d_(set_.unknowns()), law_(set_) {
    for (int i = 0; i < d_.size(); ++i) d_[i] = 0.02 * std::sin(7.0 * i + 1);  // no symmetry, reproducible
  }
  static Project project() {
    Project project;
    project.materials = {{"soft", 1000, 1e5, 0.3, 0, MaterialLaw::neo_hookean}};
    return project;
  }
  static BlockSystem system() {
    BlockSystem system;
    system.blocks = {test::box_block("tetrahedra", Vec3(0, 0, 0), Vec3(2, 1.5, 1)),
                     test::box_block("affine", Vec3(3, 0, 0), Vec3(4, 1, 1), BodyKind::affine)};
    return system;
  }
  /// All points go where F takes them.
  void deform(const Mat3& f) {
    for (Vec3& x : set_.nodes.position) x = f * x;
  }
  void turn_and_stretch(double stretch) {
    const Mat3 rotation = Eigen::AngleAxisd(0.8, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    deform(rotation * Vec3(stretch, 1.02 * stretch, stretch).asDiagonal());
  }
  Increment way_to(const Mat3& f) const {
    Increment d(set_.unknowns());
    for (const int n : set_.nodes.free)
      d.segment<3>(3 * set_.nodes.dof_block[n]) = (f - Mat3::Identity()) * set_.nodes.position[n];
    return d;
  }
  Eigen::VectorXd gradient(const Increment& d) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(d.size());
    law_.add_gradient(d, Arms::end, sum);
    return sum;
  }
  SymmetricBlocks hessian() const {
    SymmetricBlocks sum;
    std::vector<std::pair<int, int>> couplings;
    law_.add_couplings(couplings);
    sum.set_pattern(set_.nodes.movable, couplings);
    law_.add_hessian(d_, sum);
    return sum;
  }
  Voigt stress_after(const Mat3& f) {
    deform(f);
    std::vector<Voigt> stress(set_.elements.size(), Voigt::Zero());
    law_.add_stress(stress);
    for (const Voigt& s : stress) EXPECT_LT((s - stress[0]).norm(), 1e-12 * stress[0].norm());
    return stress[0];
  }

  BodySet set_;
  Increment d_;
  NeoHookeanElasticity law_;
  const Elastic elastic_ = Elastic::of(project().materials[0]);
  static constexpr StepContext moving_{.length = 0.01};
};

TEST_F(NeoHookean, StretchAlongAnAxisHasTheStressOfTheFormula) {
  for (const double stretch : {0.1, 0.6, 1.7}) {
    set_.nodes.position = set_.nodes.reference;
    const Voigt s = stress_after(Vec3(stretch, 1, 1).asDiagonal().toDenseMatrix());
    const double across = elastic_.lambda * std::log(stretch) / stretch;
    EXPECT_NEAR(s[0], elastic_.mu * (stretch * stretch - 1) / stretch + across, 1e-9 * std::abs(s[0]));
    EXPECT_NEAR(s[1], across, 1e-9 * std::abs(s[0]));
  }
}

TEST_F(NeoHookean, SimpleShearHasTheStressOfTheFormula) {
  Mat3 shear = Mat3::Identity();
  shear(0, 1) = 0.5;
  const Voigt s = stress_after(shear);
  const Voigt expected = elastic_.mu * (Voigt() << 0.25, 0, 0, 0.5, 0, 0).finished();
  EXPECT_LT((s - expected).norm(), 1e-12 * elastic_.mu);
}

TEST_F(NeoHookean, SmallStrainsAreThoseOfLinearRock) {
  Project linear = project();
  linear.materials[0].law = MaterialLaw::linear;
  const BodySet same(linear, system());
  const Increment small = 1e-6 * d_;
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(d_.size());
  CorotationalElasticity(same).add_gradient(small, Arms::end, expected);
  EXPECT_LT((gradient(small) - expected).norm(), 1e-5 * expected.norm());
}

TEST_F(NeoHookean, DerivativesOfStretchedBlocks) {
  turn_and_stretch(1.15);
  test::expect_derivatives(law_, d_, 1e-5, 1e-7);
}

TEST_F(NeoHookean, TangentOfAStepThatBearsStressAlongItsMean) {
  turn_and_stretch(0.7);
  law_.begin_step(moving_);
  test::expect_tangent_along(law_, d_, Eigen::VectorXd::LinSpaced(d_.size(), -1, 1.5), 1e-6, 1e-7);
}

/// In the last one, long and not thin, λ ln J exceeds μ: shear across it would give way.
TEST_F(NeoHookean, SqueezedAndStretchedBlocksHaveNoNegativeStiffness) {
  for (const Vec3& stretch : {Vec3(0.5, 0.51, 0.5), Vec3(2, 2.04, 2), Vec3(1, 1, 6)}) {
    deform(stretch.asDiagonal());
    const bool positive = test::has_no_negative_eigenvalue(test::dense_matrix(hessian(), d_.size()));
    EXPECT_TRUE(positive) << stretch.transpose();
    set_.nodes.position = set_.nodes.reference;
  }
}

TEST_F(NeoHookean, NoStepGivesMoreEnergyThanItsForcesTook) {
  turn_and_stretch(0.8);
  law_.begin_step(moving_);
  const double before = law_.stored_energy();
  for (const double size : {-4.0, -2.0, -0.5, 0.5, 2.0, 4.0}) {
    const double gained = law_.energy(size * d_) - before;
    ASSERT_TRUE(std::isfinite(gained)) << size;
    EXPECT_GE(gradient(size * d_).dot(size * d_), gained) << size;
  }
}

TEST_F(NeoHookean, TurningDoesNoWorkAndNoStepHasAMoment) {
  turn_and_stretch(0.9);
  const Increment turn = way_to(Eigen::AngleAxisd(0.1, Vec3(2, -1, 1).normalized()).toRotationMatrix());
  const double at_the_end = gradient(turn).dot(turn);
  law_.begin_step(moving_);
  EXPECT_LT(std::abs(gradient(turn).dot(turn)), 1e-11 * std::abs(at_the_end));

  const Eigen::VectorXd force = gradient(d_);
  Vec3 moment = Vec3::Zero();
  for (const int n : set_.nodes.free) {
    const auto first = 3 * set_.nodes.dof_block[n];
    moment += (set_.nodes.position[n] + 0.5 * d_.segment<3>(first)).cross(Vec3(force.segment<3>(first)));
  }
  EXPECT_LT(moment.norm(), 1e-12 * force.norm());
}

TEST_F(NeoHookean, TurnedInsideOutItHasNoEndOfEnergy) {
  EXPECT_EQ(law_.energy(way_to(Vec3(-1, 1, 1).asDiagonal())), std::numeric_limits<double>::infinity());
}

TEST_F(NeoHookean, AStepKeepsATenthOfEveryElementsVolume) {
  const auto least_volume = [&](const Increment& d) {
    double least = 1;
    for (std::size_t e = 0; e < set_.elements.size(); ++e)
      least = std::min(least, deformation_gradient(set_, set_.elements[e], set_.shapes[e], d).determinant());
    return least;
  };
  const Increment zero = Increment::Zero(d_.size());
  EXPECT_EQ(law_.longest_step_fraction(zero, d_), 1);
  EXPECT_EQ(law_.longest_step_fraction(zero, way_to(Vec3(2, 2, 3).asDiagonal())), 1);
  const Increment flat = way_to(Vec3(-1, 1, 1).asDiagonal());
  EXPECT_NEAR(law_.longest_step_fraction(zero, flat), 0.45, 1e-3);
  for (const double size : {50.0, 200.0, -70.0}) {
    const Increment change = size * d_;
    ASSERT_LT(least_volume(change), 0.1) << size;
    const double share = law_.longest_step_fraction(zero, change);
    EXPECT_GE(least_volume(share * change), 0.1) << size;
    EXPECT_LT(least_volume(1.01 * share * change), 0.1) << size;
    for (double s = 0; s < share; s += 0.01 * share) EXPECT_GE(least_volume(s * change), 0.1) << size;
  }
}

}  // namespace
}  // namespace talus
