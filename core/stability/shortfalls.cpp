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
      {"turning under load makes energy, first order in the step",
       {"vertex_on_vertex_pushed",
        "vertex_on_vertex_pushed_far",
        "vertex_on_edge_pushed",
        "vertex_on_edge_pushed_far",
        "edge_along_edge_dropped",
        "edge_along_edge_dropped_far",
        "edge_along_edge_pushed",
        "edge_along_edge_pushed_far",
        "edge_across_edge_dropped",
        "edge_across_edge_dropped_far",
        "edge_across_edge_pushed",
        "edge_across_edge_pushed_far",
        "friction_89_thrown",
        "domino_row_5",
        "domino_row_20",
        "poured_8",
        "interlocked_4",
        "interlocked_16",
        "column_1_degree_topples",
        "column_tenth_degree_topples"}},
      {"rock as soft as its own weight: strains beyond a corotational law",
       {"erleben_spike_on_spike", "erleben_spike_on_wedge", "erleben_wedge_on_wedge", "erleben_internal_edges"}},
      {"penetration ends at the very limit that the scene asks for",
       {"erleben_spike_in_crack", "erleben_wedge_in_crack"}},
      {"a rim in a concave corner has no contact", {"erleben_spike_in_hole"}},
      {"no stiffer than the springs that the rock's modulus gives",
       {"arch_25_slippery", "card_house_2_hit", "card_house_3_hit", "card_house_4_hit", "broken_wall", "needles_fall_3",
        "needles_fall_10"}},
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
