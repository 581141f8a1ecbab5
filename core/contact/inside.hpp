#pragma once

#include "contact/contact_points.hpp"

namespace talus {

/// Whether a point lies in a body, of whatever shape: its surface winds about it (solid angles after Van Oosterom &
/// Strackee 1983). Costs as much as the body has facets. The stability suite looks with a code of its own
/// (stability/intrusion), to see what is wrong here.
bool lies_inside(const StepGeometry& step, int body, const Vec3& point);

}  // namespace talus
