#include "effects/neo_hookean_elasticity.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "bodies/deformation.hpp"

namespace talus {

namespace {

/// Green's strain ½(FᵀF − I).
Mat3 green_strain(const Mat3& f) { return 0.5 * (f.transpose() * f - Mat3::Identity()); }

/// ln J from the strain, without the rounding of 1 where that is small. J must be above 0.
double log_volume(const Mat3& strain) {
  const double trace = strain.trace(), minors = 0.5 * (trace * trace - strain.cwiseProduct(strain).sum());
  return 0.5 * std::log1p(2 * trace + 4 * minors + 8 * strain.determinant());
}

/// S of Piola and Kirchhoff [Pa]; not a number where F is turned inside out.
Mat3 second_stress(const Elastic& elastic, const Mat3& f) {
  if (!(f.determinant() > 0)) return Mat3::Constant(std::numeric_limits<double>::quiet_NaN());
  const Mat3 strain = green_strain(f), inverse = (Mat3::Identity() + 2 * strain).inverse();
  return (2 * elastic.mu * strain + elastic.lambda * log_volume(strain) * Mat3::Identity()) * inverse;
}

Mat3 positive_part(const Mat3& s) {
  Eigen::SelfAdjointEigenSolver<Mat3> eigen;
  eigen.computeDirect(s);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
}

/// Where shear would give way, it is left out.
Elastic not_negative(const Elastic& elastic) { return {elastic.lambda, std::max(0.0, elastic.mu)}; }

/// The first fraction in 0…1 at which det(I + fraction·a) is down to kept_volume; 1 where it is never. Walks there by
/// steps that its steepest slope allows, so that none leads past it.
double fraction_that_keeps_volume(const Mat3& a, double kept_volume) {
  const double trace = a.trace(), minors = 0.5 * (trace * trace - a.cwiseProduct(a.transpose()).sum());
  const double last = a.determinant();
  const double steepest = std::abs(trace) + 2 * std::abs(minors) + 3 * std::abs(last);
  double fraction = 0;
  while (fraction < 1) {
    const double left = 1 + fraction * (trace + fraction * (minors + fraction * last)) - kept_volume;
    if (left < 0.01 * kept_volume) return fraction;
    fraction += left / steepest;
  }
  return 1;
}

}  // namespace

void NeoHookeanElasticity::add_couplings(std::vector<std::pair<int, int>>& couplings) const {
  set_.add_couplings(couplings);
}

void NeoHookeanElasticity::begin_step(const StepContext& step) {
  mean_ = step.dynamic_factor > 0 && step.integration.alpha_f == 0;
}

double NeoHookeanElasticity::energy_of(int e, const Mat3& f) const {
  if (!(f.determinant() > 0)) return std::numeric_limits<double>::infinity();
  const Elastic& elastic = set_.bodies[set_.elements[e].body].elastic;
  const Mat3 strain = green_strain(f);
  const double log = log_volume(strain);
  return set_.shapes[e].volume * (elastic.mu * (strain.trace() - log) + 0.5 * elastic.lambda * log * log);
}

double NeoHookeanElasticity::energy(const Increment& d) const {
  return sums_.energy(set_.neo_hookean, [&](int e) {
    return energy_of(e, deformation_gradient(set_, set_.elements[e], set_.shapes[e], d));
  });
}

double NeoHookeanElasticity::stored_energy() const {
  return sums_.energy(set_.neo_hookean, [&](int e) {
    return energy_of(e, deformation_gradient(set_, set_.elements[e], set_.shapes[e]));
  });
}

Mat3 NeoHookeanElasticity::bearer(int e, const Mat3& end) const {
  return mean_ ? Mat3(0.5 * (end + deformation_gradient(set_, set_.elements[e], set_.shapes[e]))) : end;
}

ElementSums::Forces NeoHookeanElasticity::forces(int e, const Increment& d) const {
  const ElementShape& shape = set_.shapes[e];
  const Mat3 f = deformation_gradient(set_, set_.elements[e], shape, d);
  const Mat3 stress = shape.volume * bearer(e, f) * second_stress(set_.bodies[set_.elements[e].body].elastic, f);
  ElementSums::Forces forces;
  for (int a = 0; a < 4; ++a) forces[a] = stress * shape.gradient[a];
  return forces;
}

void NeoHookeanElasticity::add_gradient(const Increment& d, Arms, Eigen::VectorXd& sum) const {
  sums_.add_gradient(
      set_.neo_hookean, [&](int e) { return forces(e, d); }, sum);
}

NeoHookeanElasticity::State NeoHookeanElasticity::state_of(int e, const Increment& d) const {
  const Elastic& elastic = set_.bodies[set_.elements[e].body].elastic;
  State state;
  state.f = deformation_gradient(set_, set_.elements[e], set_.shapes[e], d);
  const Mat3 s = (mean_ ? 0.5 : 1) * set_.shapes[e].volume * second_stress(elastic, state.f);
  state.pull = positive_part(s);
  state.push = s - state.pull;
  state.elastic = {elastic.lambda, elastic.mu - elastic.lambda * log_volume(green_strain(state.f))};
  state.now = set_.shapes[e];
  const Mat3 turn = state.f.inverse().transpose();
  for (Vec3& gradient : state.now.gradient) gradient = turn * gradient;
  return state;
}

ElementSums::Stiffness NeoHookeanElasticity::stiffness(int e, const Increment& d) const {
  const State state = state_of(e, d);
  const std::array<Vec3, 4>& gradient = set_.shapes[e].gradient;
  ElementSums::Stiffness blocks;
  auto block = blocks.begin();
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b <= a; ++b) {
      *block = stiffness_block(state.now, not_negative(state.elastic), a, b);
      block++->diagonal().array() += gradient[a].dot(state.pull * gradient[b]);
    }
  return blocks;
}

void NeoHookeanElasticity::add_hessian(const Increment& d, SymmetricBlocks& sum) const {
  sums_.add_hessian(
      set_.neo_hookean, [&](int e) { return stiffness(e, d); }, sum);
}

ElementSums::WholeStiffness NeoHookeanElasticity::rest_of_tangent(int e, const Increment& d) const {
  const State state = state_of(e, d);
  const std::array<Vec3, 4>& gradient = set_.shapes[e].gradient;
  const Mat3 turn = bearer(e, state.f) * state.f.inverse();
  ElementSums::WholeStiffness blocks;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) {
      blocks[a][b] = turn * stiffness_block(state.now, state.elastic, a, b) -
                     stiffness_block(state.now, not_negative(state.elastic), a, b);
      blocks[a][b].diagonal().array() += gradient[a].dot(state.push * gradient[b]);
    }
  return blocks;
}

void NeoHookeanElasticity::add_unsymmetric(const Increment& d, Arms, UnsymmetricBlocks& sum) const {
  if (!mean_) return;
  sums_.add_unsymmetric(
      set_.neo_hookean, [&](int e) { return rest_of_tangent(e, d); }, sum);
}

double NeoHookeanElasticity::longest_step_fraction(const Increment& d, const Increment& change) const {
  double fraction = 1;
  for (const int e : set_.neo_hookean) {
    const Element& element = set_.elements[e];
    const Mat3 f = deformation_gradient(set_, element, set_.shapes[e], d);
    const Mat3 slope = change_of_gradient(set_, element, set_.shapes[e], change);
    fraction = std::min(fraction, fraction_that_keeps_volume(f.inverse() * slope, tolerances_.kept_volume));
  }
  return fraction;
}

void NeoHookeanElasticity::add_stress(std::vector<Voigt>& stress) const {
  for (const int e : set_.neo_hookean) {
    const Mat3 f = deformation_gradient(set_, set_.elements[e], set_.shapes[e]);
    const Mat3 s = second_stress(set_.bodies[set_.elements[e].body].elastic, f);
    stress[e] += voigt(f * s * f.transpose() / f.determinant());
  }
}

}  // namespace talus
