#pragma once

#include <map>
#include <string>

#include "base/vector.hpp"
#include "model/project.hpp"

namespace talus {

/// What a block of body 'auto' is built as, and why in words.
struct BodyChoice {
  BodyKind body = BodyKind::tetrahedra;
  std::string reason;
};

/// Chooses from what the project asks of a block: fixed where it cannot move, tetrahedra where its stress or its
/// bending is wanted or its rock yields to its load, else affine or rigid by how much its rock is strained. The strain
/// is estimated for the whole model, ε = ρ |g| H / E + v √(ρ/E): the foot of a slope of height H bears all of it, and a
/// block that comes with the largest velocity v given at the start strains itself and whom it meets like the end of a
/// bar (Timoshenko & Goodier, Theory of Elasticity, §168). A block's shape is not looked at: one so slender that it
/// bends under its weight has to be built as tetrahedra by the user.
class BodyChooser {
 public:
  /// `extent`: m, of the box around all solids. The project has been validated.
  BodyChooser(const Project& project, const Vec3& extent);

  BodyChoice choose(const std::string& block, const Material& rock) const;

 private:
  /// What the project says of a block by its name.
  struct Wishes {
    bool moved_as_a_whole = false, held_throughout = false, in_situ_stress = false;
    std::string stress_monitor;  ///< the first that asks for its stress
    std::size_t points = 0;      ///< at which it is held or loaded, in the stage that has most
  };

  void count_points(const Project& project);
  BodyChoice choose_by_strain(const Material& rock) const;

  std::map<std::string, Wishes> wishes_;
  double weight_of_height_ = 0;  ///< m²/s², |g| H
  double speed_ = 0;             ///< m/s, the largest given at the start
};

}  // namespace talus
