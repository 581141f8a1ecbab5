#pragma once

#include <functional>
#include <string>

#include "verification/hard_cases/hard_case.hpp"

/// What holds of all nodes at all times that a run is looked at. Scenes that expect it keep their nodes.
namespace talus {

/// No node of the block is ever behind the plane by more than `allowance` [m]: else it is lost.
HardCaseExpectation nodes_stay_before(const std::string& block, const Vec3& point, const Vec3& normal,
                                      double allowance);
/// No node of a block that moves is ever farther than `allowance` [m] outside the box: else it is lost.
HardCaseExpectation nodes_stay_in_box(const Vec3& min, const Vec3& max, double allowance);
/// No node of a block that moves is ever deeper than `allowance` [m], by `depth` of its place [m]: else it is lost.
/// `surface`: "the bed".
HardCaseExpectation nodes_stay_above(const std::string& surface, const std::function<double(const Vec3&)>& depth,
                                     double allowance);
/// The block, which would meet what is fixed if it flew on under gravity alone, has another velocity at the end than
/// it had then, by more than `share` of its speed at the start: else it is lost behind it.
HardCaseExpectation is_turned_away(const std::string& block, const Vec3& gravity, double share);

/// Linear momentum, and the angular one about where the centroid of all was, stay what they were, within `share` of the
/// most that those of the blocks ever summed up to. For scenes without gravity in which nothing is fixed.
HardCaseExpectation momentum_stays(const std::vector<Material>& materials, double share);

}  // namespace talus
