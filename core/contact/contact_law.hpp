#pragma once

#include "contact/contact_point.hpp"

/// How strong a contact point is: what normal and shear contact have in common. What a joint lacks is zero here.
namespace talus {

/// Normal force at a gap [N], compression positive, paper (30), with the multiplier λ of the augmented Lagrangian where
/// it is used: λ − k_n·gap. A bond carries tension up to its strength and yields there; it breaks only when the step
/// is taken, so that the law is continuous within a step.
double normal_force(const ContactPoint& point, double gap);

/// What the springs of a point hold [J] that presses with `normal_force` [N], its multiplier included, and that bears
/// `shear_force` [N].
double normal_spring_energy(const ContactPoint& point, double normal_force);
double shear_spring_energy(const ContactPoint& point, const Vec3& shear_force);
double spring_energy(const ContactPoint& point, const ContactOutcome& outcome);

/// Whether the normal force changes with the gap there: neither open nor yielding.
bool resists_elastically(const ContactPoint& point, double gap);

/// Whether an open contact is open by less than this fraction of its size.
bool touches(const ContactPoint& point, double gap, double fraction);

/// Mohr–Coulomb strength in shear [N], paper (33)(36) with the cohesion of a bond: c·A + F_n tan φ.
double shear_strength(const ContactPoint& point, double normal_force);

}  // namespace talus
