#include "model/solver_settings.hpp"

namespace talus {

void adopt(Preset preset, SolverSettings& settings) {
  SolverSettings usual;
  if (preset == Preset::paper) {
    usual.strain = Strain::incremental;
    usual.integrator = Integrator::constant_acceleration;
    usual.contact = ContactModel::facet_wise;
    usual.open_close = OpenCloseMethod::states;
    usual.open_close_limit = 6;
    usual.static_inertia = StaticInertia::full;
    usual.extras = Extras::none;
  }
  settings.preset = preset;
  settings.strain = usual.strain;
  settings.integrator = usual.integrator;
  settings.spectral_radius = usual.spectral_radius;
  settings.contact = usual.contact;
  settings.open_close = usual.open_close;
  settings.open_close_limit = usual.open_close_limit;
  settings.static_inertia = usual.static_inertia;
  settings.extras = usual.extras;
}

SolverSettings settings_of(Preset preset) {
  SolverSettings settings;
  adopt(preset, settings);
  return settings;
}

}  // namespace talus
