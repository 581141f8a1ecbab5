#pragma once

namespace talus {

/// What the linear systems of a run have cost.
struct LinearWork {
  long factorisations = 0, dense_factorisations = 0;  ///< sparse ones, and those of small systems
  long solves = 0;                                    ///< of a system; those not solved do not count
  long gmres_iterations = 0;
  long gmres_limits = 0;  ///< solves in which GMRES used all its iterations, with a factor of the present matrix
  int systems = 0, largest_system = 0;  ///< independent ones of the present pattern, and the nodes of the largest
  double factor_seconds = 0, solve_seconds = 0;  ///< wall time; dense ones count as solve

  void archive(auto& state) {
    state(factorisations, dense_factorisations, solves, gmres_iterations, gmres_limits, systems, largest_system);
    state(factor_seconds, solve_seconds);
  }
};

}  // namespace talus
