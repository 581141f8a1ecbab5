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
      {"a soft tip on a ridge is held by edges that push against each other",
       {"erleben_spike_on_wedge", "erleben_wedge_on_wedge"}},
      {"an edge that swings in within a step is found late", {"needles_fall_3", "interlocked_16"}},
      {"what Newmark's method took for a push comes back as it ends",
       {"interlocked_4", "cube_over_bars_minus_30", "friction_89_thrown"}},
      {"friction exactly at the slope: an elastic cube keeps the speed it starts with", {"incline_50"}},
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
