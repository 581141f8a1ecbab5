#include "effects/corotational_elasticity.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cstring>

#include "bodies/deformation.hpp"
#include "bodies/finite_rotation.hpp"
#include "bodies/polar.hpp"

namespace talus {

namespace {

/// 2μE + λ tr(E) I, with E = S − I: the stress in the rotated frame [Pa]. It is symmetric to the last bit: what
/// rounding leaves of a moment would do work on the way of a block that turns.
Mat3 stress_in_frame(const Elastic& elastic, const Mat3& f, const Mat3& r) {
  const Mat3 stretch = r.transpose() * f, strain = 0.5 * (stretch + stretch.transpose()) - Mat3::Identity();
  return 2 * elastic.mu * strain + elastic.lambda * strain.trace() * Mat3::Identity();
}

/// The exact Hessian less that of linear elasticity in the rotated frame, as a form in the axial vector
/// a = axial(X − Xᵀ), X = Rᵀ dF: aᵀ [μI − c (tr S I − S)⁻¹] a with c = 2μ − λ tr E; its positive part.
Mat3 twist_stiffness(const Elastic& elastic, const Mat3& stretch) {
  const double trace = stretch.trace(), c = 2 * elastic.mu - elastic.lambda * (trace - 3);
  Eigen::SelfAdjointEigenSolver<Mat3> eigen;
  eigen.computeDirect(0.5 * (stretch + stretch.transpose()));
  Vec3 stiffness;
  for (int i = 0; i < 3; ++i) {
    const double pair = trace - eigen.eigenvalues()[i];  // sum of the two other stretches
    stiffness[i] = pair > 0 ? std::max(0.0, elastic.mu - c / pair) : 0;
  }
  return eigen.eigenvectors() * stiffness.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace

void CorotationalElasticity::add_couplings(std::vector<std::pair<int, int>>& couplings) const {
  set_.add_couplings(couplings);
}

void CorotationalElasticity::begin_step(const StepContext& step) {
  start_.clear();
  if (step.dynamic_factor == 0 || step.integration.alpha_f > 0) return;
  start_.resize(set_.elements.size());
  in_parallel(static_cast<int>(set_.linear.size()), ElementSums::grain, [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const int e = set_.linear[i];
      start_[e] = rotation(e, deformation_gradient(set_, set_.elements[e], set_.shapes[e]));
    }
  });
}

const Mat3& CorotationalElasticity::rotation(int e, const Mat3& f) const {
  Turned& last = turned_[set_.elements[e].number];
  // Bit by bit: zeros of either sign are equal, and not the same.
  if (std::memcmp(last.gradient.data(), f.data(), sizeof last.gradient) != 0) last = {f, rotation_of(f)};
  return last.rotation;
}

double CorotationalElasticity::energy_of(int e, const Mat3& f) const {
  const Elastic& elastic = set_.bodies[set_.elements[e].body].elastic;
  const Mat3 r = rotation(e, f);
  const double trace = (r.transpose() * f).trace() - 3;
  return set_.shapes[e].volume * (elastic.mu * (f - r).squaredNorm() + 0.5 * elastic.lambda * trace * trace);
}

double CorotationalElasticity::energy(const Increment& d) const {
  return sums_.energy(set_.linear, [&](int e) {
    return energy_of(e, deformation_gradient(set_, set_.elements[e], set_.shapes[e], d));
  });
}

double CorotationalElasticity::stored_energy() const {
  return sums_.energy(
      set_.linear, [&](int e) { return energy_of(e, deformation_gradient(set_, set_.elements[e], set_.shapes[e])); });
}

ElementSums::Forces CorotationalElasticity::forces(int e, const Increment& d) const {
  const ElementShape& shape = set_.shapes[e];
  const Mat3 f = deformation_gradient(set_, set_.elements[e], shape, d);
  const Mat3 r = rotation(e, f);
  const Mat3 turn = start_.empty() ? r : Mat3(0.5 * (start_[e] + r));
  const Mat3 stress = shape.volume * turn * stress_in_frame(set_.bodies[set_.elements[e].body].elastic, f, r);
  ElementSums::Forces forces;
  for (int a = 0; a < 4; ++a) forces[a] = stress * shape.gradient[a];
  return forces;
}

void CorotationalElasticity::add_gradient(const Increment& d, Arms, Eigen::VectorXd& sum) const {
  sums_.add_gradient(
      set_.linear, [&](int e) { return forces(e, d); }, sum);
}

ElementSums::Stiffness CorotationalElasticity::stiffness(int e, const Increment& d) const {
  const Elastic& elastic = set_.bodies[set_.elements[e].body].elastic;
  ElementShape turned = set_.shapes[e];
  const Mat3 f = deformation_gradient(set_, set_.elements[e], turned, d), r = rotation(e, f);
  const Mat3 twist = turned.volume * r * twist_stiffness(elastic, r.transpose() * f) * r.transpose();
  ElementSums::Stiffness blocks;
  auto block = blocks.begin();
  for (int a = 0; a < 4; ++a) turned.gradient[a] = r * turned.gradient[a];
  for (int a = 0; a < 4; ++a) {
    const Mat3 left = -cross_matrix(turned.gradient[a]) * twist;
    for (int b = 0; b <= a; ++b)
      *block++ = stiffness_block(turned, elastic, a, b) + left * cross_matrix(turned.gradient[b]);
  }
  return blocks;
}

const ElementSums::Stiffness& CorotationalElasticity::keep_stiffness(int e, const Increment& d) const {
  const Element& element = set_.elements[e];
  Kept& kept = kept_[element.number];
  const Mat3 gradient = deformation_gradient(set_, element, set_.shapes[e], d);
  if ((gradient - kept.gradient).squaredNorm() > tolerances_.stiffness_kept * tolerances_.stiffness_kept)
    kept = {gradient, stiffness(e, d)};
  return kept.stiffness;
}

void CorotationalElasticity::add_hessian(const Increment& d, SymmetricBlocks& sum) const {
  in_parallel(static_cast<int>(set_.linear.size()), ElementSums::grain, [&](int first, int last) {
    for (int i = first; i < last; ++i) keep_stiffness(set_.linear[i], d);
  });
  sums_.add_known_hessian(
      set_.linear,
      [&](std::size_t i) -> const ElementSums::Stiffness& {
        return kept_[set_.elements[set_.linear[i]].number].stiffness;
      },
      sum);
}

/// A way u of corner b turns the element by RᵀdR = ω̂, ω = (tr S I − S)⁻¹ g_b × Rᵀu, and strains it by
/// dS = Rᵀu g_bᵀ − ω̂ S; Piola's stress ½(R₀ + R) T changes by ½ R ω̂ T + ½(R₀ + R) dT.
ElementSums::WholeStiffness CorotationalElasticity::rest_of_tangent(int e, const Increment& d) const {
  const Element& element = set_.elements[e];
  const ElementShape& shape = set_.shapes[e];
  const Elastic& elastic = set_.bodies[element.body].elastic;
  const Mat3 f = deformation_gradient(set_, element, shape, d), r = rotation(e, f), mean = 0.5 * (start_[e] + r);
  const Mat3 stretch = r.transpose() * f, stress = stress_in_frame(elastic, f, r);
  const Mat3 spin = (stretch.trace() * Mat3::Identity() - stretch).inverse(), turn = mean * r.transpose();
  std::array<Mat3, 4> by_spin, spin_of_corner;
  for (int a = 0; a < 4; ++a) {
    const Vec3& g = shape.gradient[a];
    by_spin[a] = 2 * elastic.mu * times_cross(mean, stretch * g) - 0.5 * times_cross(r, stress * g);
    spin_of_corner[a] = times_cross(spin, g) * r.transpose();
  }
  const ElementSums::Stiffness& symmetric = keep_stiffness(e, d);
  ElementSums::WholeStiffness blocks;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) {
      const Vec3 &ga = shape.gradient[a], &gb = shape.gradient[b];
      blocks[a][b] = shape.volume * (by_spin[a] * spin_of_corner[b] + 2 * elastic.mu * ga.dot(gb) * turn +
                                     elastic.lambda * (mean * ga) * (r * gb).transpose()) -
                     ElementSums::block(symmetric, a, b);
    }
  return blocks;
}

void CorotationalElasticity::add_unsymmetric(const Increment& d, Arms, UnsymmetricBlocks& sum) const {
  if (start_.empty()) return;
  const double negligible = 2 * tolerances_.negligible_turn * tolerances_.negligible_turn;
  turning_.clear();
  for (const int e : set_.linear)
    if (change_of_gradient(set_, set_.elements[e], set_.shapes[e], d).squaredNorm() > negligible) turning_.push_back(e);
  sums_.add_unsymmetric(
      turning_, [&](int e) { return rest_of_tangent(e, d); }, sum);
}

void CorotationalElasticity::add_stress(std::vector<Voigt>& stress) const {
  for (const int e : set_.linear) {
    const Mat3 f = deformation_gradient(set_, set_.elements[e], set_.shapes[e]);
    const Mat3 r = rotation(e, f), p = r * stress_in_frame(set_.bodies[set_.elements[e].body].elastic, f, r);
    stress[e] += voigt(p * f.transpose() / f.determinant());
  }
}

}  // namespace talus
