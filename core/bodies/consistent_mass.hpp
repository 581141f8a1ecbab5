#pragma once

#include "bodies/body_set.hpp"
#include "linear/symmetric_blocks.hpp"

/// The consistent mass matrix of a four-node tetrahedron, m/20 (1 + δ_ab): what inertia, paper (12)–(21), and damping
/// have in common.
namespace talus {

/// uᵀ M w of an element of this mass [kg].
double mass_product(double mass, const Corners& u, const Corners& w);
inline double mass_square(double mass, const Corners& u) { return mass_product(mass, u, u); }

/// sum += scale · (1 + δ_ab) u at the element's corners.
void add_mass_times(const Element& element, double scale, const Corners& u, Eigen::VectorXd& sum);

/// sum += scale · (1 + δ_ab) I between the element's corners.
void add_mass(const Element& element, double scale, SymmetricBlocks& sum);

}  // namespace talus
