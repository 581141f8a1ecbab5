#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fields/joint_walls.hpp"
#include "results/field.hpp"

namespace talus {

class PoseFit;

/// The classes of the field "joint.state": what contacts do, and that bonds hold them.
enum class WallState : std::uint8_t { open, sticks, slides, bonded };

/// The classes of the field "asleep".
enum class SleepState : std::uint8_t { fixed, awake, asleep };

/// Values of fields on these blocks. What a field needs of the blocks at rest is made when it is asked for first.
/// Keeps a reference to `system`, which must outlive it. One thread at a time.
class FieldValues {
 public:
  explicit FieldValues(const BlockSystem& system);
  ~FieldValues();

  const BlockSystem& system() const { return system_; }
  const JointWalls& walls() const;

  /// One value a node, a tetrahedron, a block or a point of `walls()`, as `field.place()` says, SI; no number where
  /// there is none. The rotation of a block is the angle of that of least squares since the start, in degrees. Strains
  /// are those of Green and Lagrange, ½(FᵀF − 1), which turning leaves out; less than 1e-12 is rounding, and nothing.
  /// Values of joints that come from contacts are those of ContactArea at the place of the wall in this frame.
  /// Slip and opening compare the place with the one that lay against it at the start: what has come between them
  /// along the wall and across it, as the wall lay at the start. The safety of rock is `rock_safety` of blocks that
  /// have stress and whose material has a strength. Where `why_absent` has something to say all are absent.
  std::vector<double> of(const Frame& frame, const Field& field) const;

 private:
  std::vector<double> of_walls(const Frame& frame, const Field& field) const;
  std::vector<double> of_blocks(const Frame& frame, const Field& field) const;
  std::vector<double> safeties(const Frame& frame) const;
  std::vector<double> strains(const Frame& frame, const Field& field) const;

  const BlockSystem& system_;
  std::vector<double> sizes_;  // m, a block
  mutable std::unique_ptr<const JointWalls> walls_;
  mutable std::unique_ptr<const PoseFit> poses_;
};

/// Why the frame does not tell of a field, as a sentence: results of earlier versions lack some. Empty where it does.
std::string why_absent(const BlockSystem& system, const Frame& frame, const Field& field);

}  // namespace talus
