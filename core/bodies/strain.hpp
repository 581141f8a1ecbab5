#pragma once

#include <array>

#include "base/vector.hpp"
#include "model/project.hpp"

namespace talus {

using Corners = std::array<Vec3, 4>;

/// Gradients of the shape functions N_r of a four-node tetrahedron [1/m] and its volume [m³], paper (2)–(5).
struct ElementShape {
  std::array<Vec3, 4> gradient;
  double volume = 0;

  void archive(auto& state) { state(gradient, volume); }
};

/// Shape of the tetrahedron with these corners [m]. The volume of an inverted element is negative.
ElementShape element_shape(const Corners& corners);

/// Strain ε = B_e D_e of the corner displacements [m], paper (3), engineering shear strains.
Voigt strain(const ElementShape& shape, const Corners& displacement);

/// Isotropic elasticity E_e of paper (7), as Lamé's constants [Pa].
struct Elastic {
  double lambda = 0, mu = 0;
  static Elastic of(const Material& material);
  Voigt stress(const Voigt& strain) const;
  /// Strain energy density of a stress [J/m³].
  double energy_density(const Voigt& stress) const;
};

/// ∫ B_rᵀ σ dv for corner r: the force by which a stress resists a displacement of that corner [N], paper (11).
Vec3 corner_force(const ElementShape& shape, const Voigt& stress, int corner);

/// The 3×3 block (a, b) of ∫ BᵀEB dv [N/m], paper (9).
Mat3 stiffness_block(const ElementShape& shape, const Elastic& elastic, int a, int b);

}  // namespace talus
