#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bodies/block_pose.hpp"

namespace talus {

struct Frame;

/// What counts as moved, and which way is forward.
struct RunOutSettings {
  /// m; a block whose centroid has gone further has moved. None: a hundredth of the diagonal of all blocks at rest.
  std::optional<double> moved;
  /// Degrees clockwise from north, of forward. None: that of the mean displacement of the rock that moved.
  std::optional<double> azimuth;
  bool operator==(const RunOutSettings&) const = default;
};

/// The rock that moved up to a frame. Blocks that are built fixed are no part of it, however far they were moved.
struct MovedRock {
  std::vector<int> blocks;           ///< ascending
  double further_than = 0;           ///< m, each of them
  double volume = 0;                 ///< m³
  Vec3 displacement = Vec3::Zero();  ///< m, of its centre of volume
  Vec3 forward = Vec3::Zero();       ///< unit and level; zero where the rock went straight down, or none moved
};

/// Throws InputError for a length that is none.
MovedRock moved_rock(const BlockSystem& system, const Frame& frame, const RunOutSettings& settings = {});

/// One block's centroid, and how far it went in some sense.
struct FarthestBlock {
  int block = -1;     ///< −1: none moved
  double length = 0;  ///< m
};

/// From a higher place to a lower one.
struct Descent {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< m
  double height() const;                        ///< m, of the fall
  double length() const;                        ///< m, in plan
  double angle() const;                         ///< degrees below the horizontal: tan = height / length
};

/// How far the rock came that moved.
struct RunOut {
  MovedRock rock;
  FarthestBlock in_space, in_plan, forward;  ///< by the length of the displacement, of its level part, and forward
  double front = 0;                          ///< m, that the foremost point of the moved rock came forward
  /// From the highest point of the moved rock at rest, the crown of the scar, to its foremost point, the toe of the
  /// deposit: its angle is the travel angle or Fahrböschung (Heim 1932).
  Descent crown_to_toe;
  /// Of the moved rock's centre of volume; its angle is that of friction for a mass that slid and came to rest.
  Descent of_centre;
};

RunOut run_out(const BlockSystem& system, const Frame& frame, const RunOutSettings& settings = {});

/// The front at one moment.
struct FrontMoment {
  double time = 0;      ///< s
  double advance = 0;   ///< m forward of where the foremost point of the rock was at rest
  double velocity = 0;  ///< m/s forward, of the point that is foremost
  double volume = 0;    ///< m³, of blocks that have moved by now, of those that will
};

/// Follows the front of rock that has moved by some frame through all frames. Keeps a reference to `system`.
class FrontHistory {
 public:
  FrontHistory(const BlockSystem& system, MovedRock rock);
  FrontMoment at(const Frame& frame) const;

 private:
  const BlockSystem& system_;
  MovedRock rock_;
  PoseFit fit_;
  std::vector<std::size_t> first_;  ///< node of each block
};

}  // namespace talus
