#include "verification/random/random_scene.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "base/units.hpp"
#include "verification/random/families.hpp"
#include "verification/random/other_settings.hpp"

namespace talus {

namespace {

constexpr std::array all_random_bodies{RandomBodies::rigid, RandomBodies::affine, RandomBodies::tetrahedra,
                                       RandomBodies::mixed};

constexpr const char* settings_word = "settings";

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char letter : text) {
    if (letter == ':')
      parts.emplace_back();
    else
      parts.back() += letter;
  }
  return parts;
}

std::uint64_t number_in(const std::string& digits, const std::string& text) {
  std::uint64_t number = 0;
  const char* end = digits.data() + digits.size();
  const auto read = std::from_chars(digits.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end)
    throw InputError("random scene '" + text + "'", "'" + digits + "' is no whole number",
                     "write family, seed and number, like impacts:17:42");
  return number;
}

/// Drawn of numbers of its own, so that scenes stay what they were.
Elsewhere elsewhere_of(const RandomSceneName& name) {
  constexpr double far = 5e6;  // m, as national grids have it
  SceneNumbers numbers(mixed_seed(name.seed, name.family + " elsewhere", name.number));
  const double bearing = numbers.between(0, 360);
  return {numbers.between(0, 360), far * Vec3(std::cos(radians(bearing)), std::sin(radians(bearing)), 0)};
}

/// Drawn of numbers of their own, too.
void solve_by_other_settings(HardCase& scene, const RandomSceneName& name) {
  SceneNumbers numbers(mixed_seed(name.seed, name.family + ' ' + settings_word, name.number));
  const SolverSettings before = scene.build().project.solver, after = other_settings(numbers, before);
  if (const std::string changed = changed_settings(before, after); !changed.empty()) scene.title += "; " + changed;
  scene.build = [build = scene.build, after] {
    CaseScene built = build();
    built.project.solver = after;
    return built;
  };
}

}  // namespace

std::string_view to_string(RandomBodies bodies) {
  switch (bodies) {
    case RandomBodies::rigid:
      return "rigid";
    case RandomBodies::affine:
      return "affine";
    case RandomBodies::tetrahedra:
      return "tetrahedra";
    case RandomBodies::mixed:
      break;
  }
  return "mixed";
}

RandomBodies random_bodies_from(const std::string& word) {
  for (const RandomBodies bodies : all_random_bodies)
    if (to_string(bodies) == word) return bodies;
  throw InputError("bodies '" + word + "'", "there are none of that name",
                   "choose among rigid, affine, tetrahedra, mixed");
}

Draw::Draw(std::uint64_t seed, std::optional<RandomBodies> wish) : numbers(seed) {
  const RandomBodies drawn = all_random_bodies[numbers.whole(0, 3)];
  bodies_ = wish.value_or(drawn);
}

BodyKind Draw::body() {
  const int drawn = numbers.whole(0, 2);  // whatever is wished, so that what is drawn next stays
  const int kind = bodies_ == RandomBodies::mixed ? drawn : static_cast<int>(bodies_);
  return std::array{BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra}[kind];
}

const std::vector<RandomFamily>& random_families() {
  static const std::vector<RandomFamily> families{
      {"impacts", "A body that flies at a thick wall, a floor or an edge is stopped or turned away", random_impact,
       true},
      {"drops", "A body that falls on a floor, restitution 0 to 1, makes no energy and stays above", random_drop, true},
      {"collisions", "Two or three bodies that meet in space keep their momentum, also the angular one",
       random_collision, true},
      {"inclines", "A block on a plane, near the threshold or far from it, slides by the closed answer or rests",
       random_incline},
      {"wedges", "A wedge in two planes, near the threshold or far from it, slides by the closed answer or rests",
       random_wedge},
      {"toppling", "A slender block, near the threshold or far from it, tips over or stands", random_toppling},
      {"towers", "Boxes on each other, each stack of them over its base, stand", random_tower},
      {"slopes", "A bench cut by three joint sets slides or stands, above its bedding", random_slope},
      {"pours", "Bodies, also such with arms, that fall in a closed box stay in it", random_pour, true},
      {"chains", "Rings in each other hang", random_chain},
      {"shaken", "Boxes on a table that moves by a sine stay above it, and no energy is made", random_shaking, true},
      {"coincident", "Boxes whose faces, edges and corners coincide, or miss by 1e-12 to 1e-3, rest",
       random_coincidence},
      {"ratios", "Boxes of densities to 1 : 1e4 and sizes to 1 : 1e3 rest on each other", random_ratios},
      {"voronoi", "Voronoi cells on a bedding plane slide as far as friction lets them at least", random_voronoi_slope,
       true},
      {"arches", "Arches of voussoirs stand, or fall where too thin or too slippery, as their thrust line says",
       random_arch},
      {"dominoes", "A row of dominoes falls, or none, by the spin that the first is given", random_dominoes, true},
      {"caverns", "A cavern's roof cut by three joint sets: what falls stays in it", random_cavern, true},
      {"terrain", "Bodies that fall and roll on a rough bed stay above it", random_terrain, true},
      {"tangles", "Hooks, rings, wedges, slivers and plates that fall in a closed box stay in it", random_tangle, true},
  };
  return families;
}

const RandomFamily& random_family(const std::string& name) {
  std::string known;
  for (const RandomFamily& family : random_families()) {
    if (name == family.name) return family;
    known += (known.empty() ? "" : ", ") + std::string(family.name);
  }
  throw InputError("family '" + name + "'", "there is none of that name", "choose among " + known);
}

std::string to_string(const RandomSceneName& name) {
  std::string text = name.family + ':' + std::to_string(name.seed) + ':' + std::to_string(name.number);
  if (name.bodies) text += ':' + std::string(to_string(*name.bodies));
  if (name.other_settings) text += std::string(":") + settings_word;
  return text;
}

RandomSceneName random_scene_name_from(const std::string& text) {
  std::vector<std::string> parts = parts_of(text);
  const bool other_settings = parts.size() > 3 && parts.back() == settings_word;
  if (other_settings) parts.pop_back();
  if (parts.size() < 3 || parts.size() > 4)
    throw InputError("random scene '" + text + "'", "it has no family, seed and number", "write it like impacts:17:42");
  RandomSceneName name{random_family(parts[0]).name, number_in(parts[1], text), number_in(parts[2], text)};
  if (parts.size() == 4) name.bodies = random_bodies_from(parts[3]);
  name.other_settings = other_settings;
  return name;
}

HardCase random_scene(const RandomSceneName& name) {
  const RandomFamily& family = random_family(name.family);
  Draw draw(mixed_seed(name.seed, name.family, name.number), name.bodies);
  HardCase scene = family.draw(draw);
  if (!family.has_blows && !scene.has_blows) scene.elsewhere = elsewhere_of(name);
  scene.name = to_string(name);
  scene.group = name.family;
  if (name.other_settings) solve_by_other_settings(scene, name);
  return scene;
}

}  // namespace talus
