#pragma once

#include <optional>

#include "mesh/block.hpp"
#include "model/project.hpp"

namespace talus {

/// The place, in the project's coordinates [m], about which a model is computed. Sites lie 10⁶ m from the origin of
/// their grid: a coordinate is rounded there by 10⁻⁹ m, and the slip of a block at its threshold is less than that.
/// Zero for a model that lies no farther from the origin than some times its extent; else a multiple of a power of two,
/// so that no coordinate is rounded by the difference.
Vec3 local_origin(const BlockSystem& system);

/// A project and its blocks in coordinates about a local origin. Those of models near the origin are the user's own.
class LocalModel {
 public:
  /// Both outlive the model.
  LocalModel(const Project& project, const BlockSystem& system);

  const Vec3& origin() const { return origin_; }
  const Project& project() const { return moved_ ? moved_->project : project_; }
  const BlockSystem& system() const { return moved_ ? moved_->system : system_; }

 private:
  struct Moved {
    Project project;
    BlockSystem system;
  };
  const Project& project_;
  const BlockSystem& system_;
  Vec3 origin_;
  std::optional<Moved> moved_;
};

}  // namespace talus
