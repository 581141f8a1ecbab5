#pragma once

#include "bodies/body_set.hpp"
#include "contact/contact_point.hpp"
#include "effects/symmetric_blocks.hpp"

/// What normal and shear contact share: how a contact point moves, and how strong it is.
namespace talus {

/// u = Σ weight·D, first minus second body [m].
Vec3 relative_displacement(const ContactSet& contacts, const ContactPoint& point, const BodySet& set,
                           const Increment& d);

/// Normal force at a gap [N], compression positive, paper (30), with the multiplier λ of the augmented Lagrangian where
/// it is used: λ − k_n·gap. A bond carries tension up to its strength and yields
/// there; it breaks only when the step is taken, so that the law is continuous within a step.
double normal_force(const ContactPoint& point, double gap);

/// Whether the normal force changes with the gap there: neither open nor yielding.
bool resists_elastically(const ContactPoint& point, double gap);

/// Whether an open contact is open by less than this share of its size.
bool touches(const ContactPoint& point, double gap, double share);

/// Mohr–Coulomb strength in shear [N], paper (33)(36) with the cohesion of a bond: c·A + F_n tan φ.
double shear_strength(const ContactPoint& point, double normal_force);

/// Adds a force on the first body, and its opposite on the second, to a gradient (that is, subtracts it).
void subtract_contact_force(const ContactSet& contacts, const ContactPoint& point, const BodySet& set,
                            const Vec3& force, Eigen::VectorXd& sum);

/// Work that the force on the first body, and its opposite on the second, takes from nodes that are moved by
/// prescription [J]: gradient · prescribed increment.
double work_on_held_nodes(const ContactSet& contacts, const ContactPoint& point, const BodySet& set, const Vec3& force);

/// Adds the stiffness of a spring [N/m] between both sides, the K_ii, K_ij, K_ji, K_jj of paper (31) and (35).
void add_contact_spring(const ContactSet& contacts, const ContactPoint& point, const BodySet& set, const Mat3& spring,
                        SymmetricBlocks& sum);

}  // namespace talus
