#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vector.hpp"
#include "model/rock/body_kind.hpp"

/// What the project says of the blocks that cutting leaves: overrides, merges, splinters, and how they are meshed.
namespace talus {

/// Overrides for the block that holds the point `at`.
struct BlockOverride {
  std::string name;
  Vec3 at = Vec3::Zero();
  std::optional<BodyKind> body;
  std::optional<std::string> material;
  std::optional<double> mesh_size;
  bool removed = false;  ///< excavated: cut, and then left out
  bool operator==(const BlockOverride&) const = default;
};

/// The block that holds `at` and the one that holds `with`, which share a face, are one block.
struct Merge {
  Vec3 at = Vec3::Zero(), with = Vec3::Zero();  ///< m
  bool operator==(const Merge&) const = default;
};

/// What becomes of splinters.
enum class SplinterRule { refuse, drop, merge };

/// The word the project file uses.
constexpr std::string_view to_string(SplinterRule rule) {
  switch (rule) {
    case SplinterRule::drop:
      return "drop";
    case SplinterRule::merge:
      return "merge";
    case SplinterRule::refuse:
      break;
  }
  return "refuse";
}

/// Splinters are blocks thinner than `thickness`, and chips: those whose volume is less than `chip_volume` of the
/// median of all blocks that their solid is cut into, but for those that the project names.
struct Splinters {
  std::optional<double> thickness{};       ///< m; 1e-4 of the mesh size when absent
  SplinterRule rule = SplinterRule::drop;  ///< merge: with the neighbour that it shares most of its surface with
  double chip_volume = 1e-6;               ///< that of what is a hundredth as long, wide and high
  bool operator==(const Splinters&) const = default;
};

/// Around a point or a flat face blocks are meshed more finely, or more coarsely.
struct MeshRefinement {
  Vec3 at = Vec3::Zero();    ///< m; counts where there is no face
  double radius = 0;         ///< m, within which `size` holds; beyond it grows to the blocks' own over one more radius
  double size = 0;           ///< m
  std::vector<Vec3> face{};  ///< m, corners in order; empty: around the point
  bool operator==(const MeshRefinement&) const = default;
};

struct MeshSettings {
  std::optional<double> size{};  ///< m, of solids that say none
  std::vector<MeshRefinement> refinements{};
  double most_tetrahedra = 5e6;  ///< a mesh that would have more is refused
  bool operator==(const MeshSettings&) const = default;
};

}  // namespace talus
