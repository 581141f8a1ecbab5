#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "bodies/block_pose.hpp"
#include "results/result_folder.hpp"

namespace talus {

/// A block in one frame.
struct BlockState {
  Vec3 displacement = Vec3::Zero(), velocity = Vec3::Zero();         ///< m, m/s, of the centroid
  double rotation = 0;                                               ///< degrees since the start, 0 to 180
  double kinetic_energy = std::numeric_limits<double>::quiet_NaN();  ///< J; NaN where its density is not known
  double stress = 0;                                                 ///< Pa, the largest von Mises stress in it
  Vec3 contact_force = Vec3::Zero();                                 ///< N, on it, of all its contacts
  double normal_force = 0, shear_force = 0;                          ///< N, magnitudes summed over its contacts
};

/// A number that a block has at every moment.
struct BlockQuantity {
  std::string_view name;   ///< as in `--quantity`, for example "speed"
  std::string_view title;  ///< for an axis
  std::string_view unit;   ///< SI
  double (*of)(const BlockState&);

  bool operator==(const BlockQuantity& other) const { return name == other.name; }
};

/// Every quantity, in the order in which a menu shows them.
std::span<const BlockQuantity> all_block_quantities();

/// Throws InputError that lists the names.
const BlockQuantity& block_quantity_named(std::string_view name);

/// Looks at blocks frame by frame. Keeps a reference to `system`.
class BlockWatch {
 public:
  /// kg/m³, a material; none: kinetic energies are not known.
  explicit BlockWatch(const BlockSystem& system, std::vector<double> densities = {});
  /// One a block of `blocks`, in their order.
  std::vector<BlockState> states(const Frame& frame, std::span<const int> blocks) const;

 private:
  double kinetic_energy(const Block& block, const Vec3* velocity) const;

  const BlockSystem& system_;
  std::vector<double> densities_;
  PoseFit fit_;
  std::vector<std::size_t> first_node_, first_tetrahedron_;  ///< a block
};

/// What became of blocks.
struct BlockHistory {
  std::vector<double> times;                      ///< s, of all frames
  std::vector<int> blocks;                        ///< that it tells of
  std::vector<std::string> names;                 ///< of these
  std::vector<std::vector<BlockState>> of_block;  ///< of each of them a state a frame

  std::vector<double> values(std::size_t block, const BlockQuantity& quantity) const;
};

/// Of all frames. Throws Cancelled.
BlockHistory block_history(const ResultReader& results, std::vector<int> blocks, std::vector<double> densities,
                           Progress& progress);

/// The table of these quantities over time: "time [s]", "B1.speed [m/s]" …, names quoted as CSV asks for.
std::string history_csv(const BlockHistory& history, std::span<const BlockQuantity> quantities);

}  // namespace talus
