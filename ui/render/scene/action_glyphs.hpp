#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/vector.hpp"

namespace talus {

struct BlockSystem;
struct Project;

/// Something that acts on the rock or watches it, as a picture shows it: an arrow for a load or a velocity, cones for a
/// support, a point for a monitor, a cross for stress in situ.
struct ActionGlyph {
  enum class Kind { load, support, velocity, stress, monitor };
  struct Principal {
    Vec3 direction = Vec3::Zero();  ///< unit
    double value = 0;               ///< Pa, tension positive
    bool operator==(const Principal&) const = default;
  };
  Kind kind = Kind::load;
  int index = -1;                    ///< in the project's list of its kind
  int block = -1;                    ///< into BlockSystem::blocks, with which it moves; −1: with none
  Vec3 at = Vec3::Zero();            ///< m, on the rock at rest
  Vec3 arrow = Vec3::Zero();         ///< N of a load, m/s of a velocity, m by which a support moves its point
  Vec3 spin = Vec3::Zero();          ///< rad/s of a velocity
  std::array<bool, 3> held{};        ///< directions that a support holds
  std::array<Principal, 3> cross{};  ///< principal stresses
  bool pushes = false;               ///< a load that acts into its block: the arrow ends at the point
  std::string label;                 ///< "250 kN", the name of a monitor
  bool selected = false;
  bool operator==(const ActionGlyph&) const = default;
};

/// Loads, supports, initial velocities, stress in situ and monitors of a project on its blocks, as far as they have a
/// place: a block that moves at the start is to be cut first, or has a name. Of what changes with time the largest is
/// shown. Stress in situ is shown at three heights of the blocks that bear it.
std::vector<ActionGlyph> action_glyphs(const Project& project, const BlockSystem& system);

/// The largest arrow, or stress, of a kind: what its longest glyph stands for. 0 where there is none.
double largest_of(const std::vector<ActionGlyph>& glyphs, ActionGlyph::Kind kind);

/// "250 kN": three figures without zeros at their end, with the prefix that suits; `unit` is N, Pa, m/s, m or rad/s.
std::string amount_text(double value, const std::string& unit);

}  // namespace talus
