#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/vector.hpp"
#include "render/paint/colour.hpp"

/// What may be shown of a scene's blocks beside their shape.
namespace talus {

struct BlockSystem;

/// A dot of the picture and what it means.
struct KeyEntry {
  Rgb colour;
  std::string meaning;
};

/// A colour for each block, and what the colours mean.
struct BlockColours {
  std::string title;          ///< of the key: "Material"
  std::vector<Rgb> colours;   ///< in the order of BlockSystem::blocks
  std::vector<KeyEntry> key;  ///< empty: there is nothing to say
};

/// Tol's colours, calmed by a quarter of grey, for blocks that have no other: neighbours have different ones, and fixed
/// rock has that of rock.
std::vector<Rgb> colours_of_blocks(const BlockSystem& system);
/// The same, red, green and blue from 0 to 1.
std::vector<std::array<double, 3>> fractions_of_colours(const BlockSystem& system);

/// A place of the blocks as they were cut that is marked over everything, by a ring and a label.
struct MarkedPlace {
  Vec3 at = Vec3::Zero();  ///< m
  double size = 1;         ///< m, of what is there
  std::string label;
  bool operator==(const MarkedPlace&) const = default;
};

}  // namespace talus
