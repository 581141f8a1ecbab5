#include "bodies/time_integration.hpp"

namespace talus {

TimeIntegration TimeIntegration::generalized_alpha(double rho) {
  TimeIntegration t;
  t.alpha_m = (2 * rho - 1) / (rho + 1);
  t.alpha_f = rho / (rho + 1);
  t.gamma = 0.5 - t.alpha_m + t.alpha_f;
  t.beta = 0.25 * (1 - t.alpha_m + t.alpha_f) * (1 - t.alpha_m + t.alpha_f);
  return t;
}

TimeIntegration TimeIntegration::of(const SolverSettings& settings) {
  switch (settings.integrator) {
    case Integrator::newmark:
      return newmark();
    case Integrator::constant_acceleration:
      return constant_acceleration();
    case Integrator::generalized_alpha:
      break;
  }
  return generalized_alpha(settings.spectral_radius);
}

}  // namespace talus
