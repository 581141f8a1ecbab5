#pragma once

#include "stability/stability_scene.hpp"

/// The words in which scenes say what they expect.
namespace talus {

/// The block goes nowhere after the end of the stage (−1: after the start): by less than `distance` [m], and turns by
/// less than `angle` [degrees].
Demand rests(const std::string& block, int stage, double distance, double angle = 0.01);
/// All movable blocks do.
Demand all_rest(int stage, double distance, double angle = 0.01);
/// The block's way along `direction` (unit) from the start is `distance` [m] within the share `tolerance` of it.
Demand travels(const std::string& block, const Vec3& direction, double distance, double tolerance);
/// … is at least `least` [m].
Demand travels_at_least(const std::string& block, const Vec3& direction, double least);
/// The block has turned by at least `angle` [degrees].
Demand topples(const std::string& block, double angle);
/// The block's speed at the end is below `speed` [m/s].
Demand stops(const std::string& block, double speed);
/// After `since` [s] the block is never faster than it was at first there, by more than `gain` [m/s].
Demand gains_no_speed(const std::string& block, double since, double gain);
/// The centroids of all movable blocks stay on the side of the plane that `normal` points to, at all moments: nothing
/// passes through.
Demand stays_before(const Vec3& point, const Vec3& normal);

}  // namespace talus
