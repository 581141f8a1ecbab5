#pragma once

#include "verification/hard_cases/hard_case.hpp"

/// The words in which scenes say what they expect.
namespace talus {

/// The block goes nowhere after the end of the stage (−1: after the start): by less than `distance` [m], and turns by
/// less than `angle` [degrees].
HardCaseExpectation rests(const std::string& block, int stage, double distance, double angle = 0.01);
/// All movable blocks do.
HardCaseExpectation all_rest(int stage, double distance, double angle = 0.01);
/// The block's displacement along `direction` (unit) since the end of the stage (−1: the start) is `distance` [m],
/// within `tolerance` of it.
HardCaseExpectation travels(const std::string& block, const Vec3& direction, double distance, double tolerance,
                            int stage = -1);
/// … from the start is at least `least` [m].
HardCaseExpectation travels_at_least(const std::string& block, const Vec3& direction, double least);
/// Over the second half of the last stage the block's displacements along `direction` (unit) are those of
/// `acceleration` [m/s²] in the mean (least squares), within `tolerance` of it.
HardCaseExpectation accelerates(const std::string& block, const Vec3& direction, double acceleration, double tolerance);
/// The block has turned by at least `angle` [degrees].
HardCaseExpectation topples(const std::string& block, double angle);
/// The block's speed at the end is below `speed` [m/s].
HardCaseExpectation stops(const std::string& block, double speed);
/// After `since` [s] the block is never faster than it was at first there, by more than `gain` [m/s].
HardCaseExpectation gains_no_speed(const std::string& block, double since, double gain);
/// The centroids of all movable blocks stay on the side of the plane that `normal` points to, in all snapshots: nothing
/// passes through.
HardCaseExpectation stays_before(const Vec3& point, const Vec3& normal);
/// A block that stands on a point or an edge, in unstable equilibrium, comes down only by going aside or turning over,
/// not through what bears it: wherever its centroid is lower than `allowance` [m] against `up`, it has gone aside by a
/// twentieth of the rest (faces of our spikes and wedges are no steeper than 10 to 1) or turned by 5°.
HardCaseExpectation comes_down_aside(const std::string& block, const Vec3& up, double allowance);

/// That of all movable blocks at the end, by volume [m].
Vec3 mean_displacement(const Trajectory& trajectory);

}  // namespace talus
