#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/tet_mesh.hpp"
#include "render/scene/scene.hpp"

namespace talus {

/// Where the camera is at a moment.
struct CameraKey {
  double time = 0;                                            ///< s, of the model
  Vec3 position = Vec3::Zero(), focal_point = Vec3::UnitX();  ///< m
};

/// The keys of a table "time [s],x [m],y [m],z [m],to x [m],to y [m],to z [m]", where the camera stands and where it
/// looks to. Throws InputError for one without rows, whose times do not grow, or that looks to where it stands.
std::vector<CameraKey> read_camera_keys(const std::filesystem::path& file);

/// Such a table.
std::string camera_keys_csv(const std::vector<CameraKey>& keys);

/// How the camera moves in a film; of nothing it stands still.
struct CameraMoves {
  std::vector<CameraKey> keys;  ///< it goes smoothly from one to the next
  double turn = 0;              ///< degrees about the vertical, from the first picture to the last, anticlockwise
  std::optional<int> follow;    ///< this block stays in the middle, some times as large as it would be
};

/// The way of the camera through a film.
class CameraPath {
 public:
  /// `held`: where it would stand still.
  CameraPath(const CameraMoves& moves, const BlockSystem& system, const CameraPose& held);

  bool stands_still() const;
  /// In a picture of this frame, which is `share` of the film, 0 to 1.
  CameraPose pose(const Frame& frame, double share) const;

 private:
  CameraPose at_key(double time) const;

  CameraMoves moves_;
  CameraPose held_;
  std::size_t first_ = 0, count_ = 0;  ///< nodes of the block that is followed
  Vec3 middle_ = Vec3::Zero();         ///< m, of that block at rest
};

}  // namespace talus
