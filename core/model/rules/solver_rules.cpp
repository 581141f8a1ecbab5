#include "model/rules/solver_rules.hpp"

#include <string>

#include "model/number_text.hpp"
#include "model/require.hpp"

namespace talus {
namespace {

void check(const AdaptiveSteps& steps, const Place& place) {
  require_positive(steps.displacement_limit, place / "displacement_limit", "the displacement limit",
                   "half the model's height; 0.005 is usual");
  require_positive(steps.error_limit, place / "error_limit", "the error limit",
                   "the smallest mesh size; 1e-4 is usual");
  require(steps.iterations >= 1, place / "iterations",
          "at least one open–close iteration is needed, not " + std::to_string(steps.iterations),
          "give the iterations above which the next step is shorter; 8 is usual");
  require_positive(steps.shortest, place / "shortest", "the shortest step", "the stage's time_step; 1e-3 is usual");
  require(steps.shortest <= 1, place / "shortest",
          "the shortest step is longer than the stage's time_step: " + number_text(steps.shortest) + " of it",
          "give at most 1; 1e-3 is usual");
}

}  // namespace

void check(const SolverSettings& solver) {
  const Place place = Place() / "solver";
  const SolverSettings usual;
  require_finite(solver.spectral_radius, place / "spectral_radius");
  require(solver.spectral_radius >= 0 && solver.spectral_radius <= 1, place / "spectral_radius",
          "the spectral radius must be 0 to 1, is " + number_text(solver.spectral_radius),
          "give 1 for no numerical damping, less for more; 0.8 is usual");
  require(solver.integrator == Integrator::generalized_alpha || solver.spectral_radius == usual.spectral_radius,
          place / "spectral_radius",
          "the integrator '" + std::string(to_string(solver.integrator)) + "' has no spectral radius",
          "use the integrator 'generalized-alpha', or leave the spectral radius out");
  require_positive(solver.contact_stiffness, place / "contact_stiffness", "contact stiffness",
                   "E/h, a number without unit; 10 is usual");
  if (solver.penetration_tolerance) {
    require_positive(*solver.penetration_tolerance, place / "penetration_tolerance", "the penetration tolerance",
                     "the mesh size; 1e-6 is strict");
  }
  require_finite(solver.tolerance, place / "tolerance");
  require(is_tolerance(solver.tolerance), place / "tolerance",
          "the tolerance must be 1e-12 to 0.01 of the largest force, is " + number_text(solver.tolerance),
          "give \"draft\" (1e-3), \"standard\" (1e-6), \"reference\" (1e-10) or a number between");
  require(solver.open_close_limit >= 1, place / "open_close_limit",
          "at least one open–close iteration is needed, not " + std::to_string(solver.open_close_limit),
          "give the iterations after which the step is cut; " + std::to_string(usual.open_close_limit) + " is usual");
  const double sleep_tolerance = solver.sleep_tolerance.value_or(0);
  require_finite(sleep_tolerance, place / "sleep_tolerance");
  require(sleep_tolerance >= 0, place / "sleep_tolerance",
          "the sleep tolerance must not be negative, is " + number_text(sleep_tolerance),
          "give the speed in mesh sizes a second below which a block is at rest; 0 keeps all awake");
  check(solver.adaptive, place / "adaptive");
  require(solver.time_step_control == TimeStepControl::adaptive || solver.adaptive == usual.adaptive,
          place / "adaptive", "limits of adaptive steps are given, and the steps are fixed",
          "add \"time_step_control\": \"adaptive\", or leave the limits out");
}

}  // namespace talus
