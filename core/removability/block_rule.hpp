#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "removability/block_facts.hpp"

/// Blocks that are meant by what is known of them rather than one by one.
namespace talus {

enum class Side { below, above };

struct ByVolume {
  Side side = Side::below;
  double volume = 0;  ///< m³
};
/// Twice the volume over the surface is less than this: the thickness of a plate.
struct ByThickness {
  double below = 0;  ///< m
};
/// The block's centroid lies on one side of a plane; above is where its normal points.
struct ByPlane {
  Side side = Side::below;
  Vec3 through = Vec3::Zero();  ///< m
  Vec3 normal = Vec3::UnitZ();  ///< of any length
};
/// It has a face on the joint.
struct ByJoint {
  int joint = 0;  ///< index into Project::joints
};
/// It has a face that lies against no other block.
struct ByFreeFace {};
/// It can leave its place by block theory; in a certain way, or with a factor of safety below some value, if these are
/// given. Fixed blocks never do.
struct ByRemovability {
  std::optional<Leaving> mode{};
  std::optional<double> factor_below{};
};
struct ByBody {
  BodyKind body = BodyKind::tetrahedra;
};
struct ByMaterial {
  int material = 0;  ///< index into Project::materials
};
struct BySolid {
  int solid = 0;  ///< index into Project::solids
};
/// Its name is like the pattern, large or small letters alike: `*` stands for any letters, `?` for one; a pattern
/// without these is looked for anywhere in the name.
struct ByName {
  std::string pattern;
};

using BlockRule = std::variant<ByVolume, ByThickness, ByPlane, ByJoint, ByFreeFace, ByRemovability, ByBody, ByMaterial,
                               BySolid, ByName>;

/// Indices of the blocks that the rule means, ascending. `facts` are those of the system.
std::vector<int> blocks_by(const BlockRule& rule, const BlockSystem& system, const std::vector<BlockFacts>& facts);

/// What becomes of those that are selected already.
enum class Combination { replace, add, remove, within };

/// Both ascending, and so is what comes of them.
std::vector<int> combined(const std::vector<int>& selected, const std::vector<int>& found, Combination how);

/// All the others of `count` blocks.
std::vector<int> inverted(const std::vector<int>& selected, int count);

/// With all blocks that they lie against.
std::vector<int> grown(const std::vector<int>& selected, const std::vector<BlockFacts>& facts);

/// Pairs of neighbours among the blocks that join all of them, each pair with a block that those before have joined
/// already; empty where they do not hang together, or are fewer than two.
std::vector<std::pair<int, int>> joining_pairs(const std::vector<int>& blocks, const std::vector<BlockFacts>& facts);

}  // namespace talus
