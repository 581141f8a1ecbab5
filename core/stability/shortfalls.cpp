#include "stability/shortfalls.hpp"

#include <algorithm>
#include <vector>

namespace talus {

namespace {

struct Cause {
  const char* words;
  std::vector<const char*> scenes;
};

/// Short, since every row of the table says it; docs/stability.md has the whole.
const std::vector<Cause>& causes() {
  static const std::vector<Cause> list{
      {"rock as soft as its own weight: strains beyond a corotational law",
       {"erleben_spike_on_spike", "erleben_spike_on_wedge", "erleben_wedge_on_wedge", "erleben_internal_edges"}},
      {"penetration ends at the very limit that the scene asks for", {"erleben_wedge_in_crack"}},
      {"a rim in a concave corner has no contact", {"erleben_spike_in_hole"}},
      {"hit harder than springs of 10 E/h bear within a thousandth",
       {"arch_25_slippery", "card_house_2_hit", "broken_wall", "needles_fall_3"}},
      {"not traced: a few millionths of the energy", {"interlocked_4", "interlocked_16", "cube_over_bars_minus_30"}},
      {"friction exactly at the slope lets go by rounding", {"incline_50"}},
      {"a static stage under a ratio of 10 000 gives back 5e-6", {"heavy_on_light"}},
      {"a needle on its tip does not settle to round-off", {"needle_elastic_dropped"}},
  };
  return list;
}

}  // namespace

std::string known_shortfall(const std::string& scene) {
  for (const Cause& cause : causes())
    if (std::find(cause.scenes.begin(), cause.scenes.end(), scene) != cause.scenes.end()) return cause.words;
  return "";
}

}  // namespace talus
