#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "orientation/random_numbers.hpp"

namespace talus {

/// What chance decides of a scene: the same for the same seed on every machine.
class SceneNumbers {
 public:
  explicit SceneNumbers(std::uint64_t seed) : even_(seed) {}

  double between(double low, double high);      ///< drawn evenly
  double logarithmic(double low, double high);  ///< each order of magnitude is as likely
  int whole(int low, int high);                 ///< both included
  bool chance(double probability);
  Vec3 direction();  ///< of length 1
  Mat3 turn();       ///< every rotation is as likely

  template <typename Item>
  const Item& one_of(const std::vector<Item>& items) {
    return items[whole(0, static_cast<int>(items.size()) - 1)];
  }

 private:
  RandomNumbers even_;
};

/// The seed of one scene out of the user's, the family's name and the scene's number in it: neighbours have nothing in
/// common.
std::uint64_t mixed_seed(std::uint64_t seed, std::string_view family, std::uint64_t number);

}  // namespace talus
