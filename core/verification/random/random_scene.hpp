#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verification/hard_cases/hard_case.hpp"
#include "verification/random/scene_numbers.hpp"

/// Scenes that chance draws, so that no method can be tuned to them. Each is a hard case, made of a name alone.
namespace talus {

/// Which bodies blocks that move are.
enum class RandomBodies { rigid, affine, tetrahedra, mixed };

/// The word in names of scenes and on the command line.
std::string_view to_string(RandomBodies bodies);
/// Throws InputError for another word.
RandomBodies random_bodies_from(const std::string& word);

/// What a family draws of: numbers, and bodies by the user's choice or by chance, which leaves all else as it was.
class Draw {
 public:
  Draw(std::uint64_t seed, std::optional<RandomBodies> wish);

  SceneNumbers numbers;
  BodyKind body();  ///< of the next block
  std::string bodies_word() const { return std::string(to_string(bodies_)); }

 private:
  RandomBodies bodies_;
};

/// A kind of scene. What it draws is named and titled by whoever asks for it: `draw` fills in title, expectations and
/// how it is built.
struct RandomFamily {
  const char* name;   ///< "impacts", for the command line
  const char* title;  ///< what its scenes are and must come to, a line for tables
  HardCase (*draw)(Draw&);
  /// Blows make much of rounding, so that its scenes need not come to the same at another place.
  bool has_blows = false;
};

/// All there are.
const std::vector<RandomFamily>& random_families();
/// Throws InputError where there is none of that name.
const RandomFamily& random_family(const std::string& name);

/// Of which scene everything follows.
struct RandomSceneName {
  std::string family;
  std::uint64_t seed = 1, number = 1;
  std::optional<RandomBodies> bodies{};  ///< empty: drawn too
  bool other_settings = false;           ///< the same scene, solved by others that must not matter
  bool operator==(const RandomSceneName&) const = default;
};

/// "impacts:17:42", "impacts:17:42:rigid:settings": family, seed, number and, where it was chosen, what bodies are, and
/// that settings are others.
std::string to_string(const RandomSceneName& name);
/// Throws InputError for what is no such name, or of no family there is.
RandomSceneName random_scene_name_from(const std::string& text);

/// The same for the same name on every machine. Its group is its family.
HardCase random_scene(const RandomSceneName& name);

}  // namespace talus
