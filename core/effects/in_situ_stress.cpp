#include "effects/in_situ_stress.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "bodies/deformation.hpp"

namespace talus {

namespace {

/// The part of a stress that pulls.
Mat3 tension_of(const Mat3& stress) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(stress);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
}

bool concerns(const InSituStress& given, const std::string& block) {
  return given.blocks.empty() || std::find(given.blocks.begin(), given.blocks.end(), block) != given.blocks.end();
}

}  // namespace

std::vector<Voigt> stress_before(const Project& project, const BlockSystem& system, const BodySet& set) {
  std::vector<Voigt> stress(set.elements.size(), Voigt::Zero());
  for (std::size_t e = 0; e < set.elements.size(); ++e) {
    double height = 0;
    for (const int node : set.elements[e].nodes) height += set.nodes.reference[node].z() / 4;
    for (const InSituStress& given : project.in_situ)
      if (concerns(given, system.blocks[set.elements[e].body].name))
        stress[e] += given.stress + (height - given.level) * given.gradient;
  }
  return stress;
}

InSituStresses::InSituStresses(const Project& project, const BlockSystem& system, const BodySet& set) : set_(set) {
  const std::vector<Voigt> before = stress_before(project, system, set);
  stress_.resize(set.element_numbers);
  pulling_.resize(set.element_numbers);
  for (std::size_t e = 0; e < before.size(); ++e) {
    const int number = set.elements[e].number;
    stress_[number] = tensor(before[e]);
    pulling_[number] = tension_of(stress_[number]);
  }
}

void InSituStresses::add_couplings(std::vector<std::pair<int, int>>& couplings) const { set_.add_couplings(couplings); }

double InSituStresses::energy(const Increment& d) const {
  double sum = 0;
  for (std::size_t e = 0; e < set_.elements.size(); ++e) {
    const Mat3 f = deformation_gradient(set_, set_.elements[e], set_.shapes[e], d);
    sum += 0.5 * set_.shapes[e].volume *
           (stress_[set_.elements[e].number].cwiseProduct(f.transpose() * f).sum() -
            stress_[set_.elements[e].number].trace());
  }
  return sum;
}

double InSituStresses::stored_energy() const { return energy(Increment::Zero(set_.unknowns())); }

void InSituStresses::begin_step(const StepContext& step) {
  end_fraction_ = step.dynamic_factor == 0 || step.integration.alpha_f > 0 ? 1 : 0.5;
}

void InSituStresses::add_gradient(const Increment& d, Arms, Eigen::VectorXd& sum) const {
  at_ = end_fraction_ * d;
  for (std::size_t e = 0; e < set_.elements.size(); ++e) {
    const ElementShape& shape = set_.shapes[e];
    const Mat3 p =
        shape.volume * deformation_gradient(set_, set_.elements[e], shape, at_) * stress_[set_.elements[e].number];
    for (int a = 0; a < 4; ++a) sum.segment<3>(3 * set_.elements[e].dof_blocks[a]) += p * shape.gradient[a];
  }
}

void InSituStresses::add_hessian(const Increment&, SymmetricBlocks& sum) const {
  for (std::size_t e = 0; e < set_.elements.size(); ++e) {
    const ElementShape& shape = set_.shapes[e];
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b)
        sum.add(set_.elements[e].dof_blocks[a], set_.elements[e].dof_blocks[b],
                end_fraction_ * shape.volume *
                    shape.gradient[a].dot(pulling_[set_.elements[e].number] * shape.gradient[b]) * Mat3::Identity());
  }
}

void InSituStresses::add_stress(std::vector<Voigt>& stress) const {
  for (std::size_t e = 0; e < set_.elements.size(); ++e) {
    const Mat3 f = deformation_gradient(set_, set_.elements[e], set_.shapes[e]);
    stress[e] += voigt(f * stress_[set_.elements[e].number] * f.transpose() / f.determinant());
  }
}

}  // namespace talus
