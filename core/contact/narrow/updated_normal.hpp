#pragma once

#include <span>

#include "contact/found_point.hpp"

namespace talus {

/// The normal of a point, found with its nodes at `start` [m], once they are at `end` [m]. A vertex has that of the
/// facet it lies on, crossing edges the direction across both, face–face contact the one halfway between both facets.
/// Vertex–vertex contact keeps its normal, which follows from positions more than from how features are turned.
Vec3 updated_normal(const ContactFeatures& features, const FoundPoint& point, std::span<const Vec3> start,
                    std::span<const Vec3> end);

}  // namespace talus
