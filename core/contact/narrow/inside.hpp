#pragma once

#include "contact/narrow/step_geometry.hpp"

namespace talus {

/// Whether a point lies in a body, of whatever shape: its surface winds about it (solid angles after Van Oosterom &
/// Strackee 1983). Costs as much as the body has facets. The hard cases look for interpenetration with a code of
/// their own, to see what is wrong here.
bool lies_inside(const StepGeometry& step, int body, const Vec3& point);

}  // namespace talus
