#pragma once

#include <utility>
#include <vector>

#include "bodies/body_set.hpp"
#include "effects/effect.hpp"
#include "mesh/structured_mesh.hpp"
#include "support/solver_scenes.hpp"

/// Effects of hardly any size, for what the solver makes of effects.
namespace talus::test {

constexpr int chain_nodes = 12;  ///< too many for the dense solver
inline const std::vector<std::pair<int, int>> no_contacts;

/// A chain of springs, each node held by a spring of its own; counts how often it is assembled.
class SpringChain final : public Effect {
 public:
  enum class Stays { through_the_stage, through_the_step };
  SpringChain(Stays stays, int& assembled, EnergyAccount account = EnergyAccount::potential)
      : stays_(stays), assembled_(assembled), account_(account) {}
  EffectKind kind() const override { return EffectKind::elasticity; }
  EnergyAccount account() const override { return account_; }
  bool constant() const override { return stays_ == Stays::through_the_stage; }
  void add_couplings(std::vector<std::pair<int, int>>& couplings) const override {
    for (int node = 1; node < chain_nodes; ++node) couplings.emplace_back(node, node - 1);
  }
  double energy(const Increment&) const override { return 0; }
  void add_gradient(const Increment& d, Arms, Eigen::VectorXd& sum) const override {
    SymmetricBlocks stiffness;
    std::vector<std::pair<int, int>> couplings;
    add_couplings(couplings);
    stiffness.set_pattern(chain_nodes, couplings);
    fill(stiffness);
    Eigen::VectorXd force;
    stiffness.multiply(d, force);
    sum += force;
  }
  void add_hessian(const Increment&, SymmetricBlocks& sum) const override {
    ++assembled_;
    fill(sum);
  }

 private:
  static void fill(SymmetricBlocks& sum) {
    for (int node = 0; node < chain_nodes; ++node) {
      sum.add(node, node, 3 * Mat3::Identity());
      if (node > 0) sum.add(node, node - 1, -Mat3::Identity());
    }
  }
  Stays stays_;
  int& assembled_;
  EnergyAccount account_;
};

/// Pulls at every node.
class Load final : public Effect {
 public:
  explicit Load(EnergyAccount account = EnergyAccount::potential) : account_(account) {}
  EffectKind kind() const override { return EffectKind::point_load; }
  EnergyAccount account() const override { return account_; }
  double energy(const Increment&) const override { return 0; }
  void add_gradient(const Increment&, Arms, Eigen::VectorXd& sum) const override {
    sum -= Eigen::VectorXd::LinSpaced(sum.size(), 1, 2);
  }

 private:
  EnergyAccount account_;
};

/// A body whose nodes are those of the chain and whose unknowns add up.
inline BodySet chain_body() {
  Block block;
  block.name = "chain";
  block.mesh = box_mesh(Vec3(0, 0, 0), Vec3(2, 1, 1), 2, 1, 1);
  block.surface = boundary(block.mesh);
  Project project = rock_project(30, {});
  project.solver.strain = Strain::incremental;
  return {project, block_system({block})};
}

inline StepContext step_of(double length) {
  StepContext step;
  step.length = length;
  step.mesh_size = step.extent = 1;
  return step;
}

}  // namespace talus::test
