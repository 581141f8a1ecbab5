#pragma once

#include <functional>

#include "contact/contact_points.hpp"

namespace talus {

/// The normal of a point once its features have turned to where `end` [m] has their nodes; it was found at `start`. A
/// vertex has that of the facet it lies on, crossing edges the direction across both, facing facets the one halfway. A
/// meeting keeps what it has: its normal is one of positions more than of features.
Vec3 turned_normal(const ContactFeatures& features, const FoundPoint& point, const std::function<Vec3(int)>& start,
                   const std::function<Vec3(int)>& end);

}  // namespace talus
