#pragma once

namespace talus {

/// Wall seconds of the parts of an iteration.
struct SolveTimes {
  double assemble = 0, factor = 0, solve = 0, update = 0;

  void archive(auto& state) { state(assemble, factor, solve, update); }
};

}  // namespace talus
