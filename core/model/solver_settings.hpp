#pragma once

#include <array>
#include <optional>
#include <string_view>

/// How a scene is solved: what accuracy costs in time is decided here.
namespace talus {

/// Measured from the undeformed shape in the rotated frame, or summed up step by step as the paper does.
enum class Strain { corotational, incremental };

/// Newmark's method with γ = 1, β = 9/16; the paper's, γ = 1, β = ½; Chung & Hulbert's generalised-α.
enum class Integrator { newmark, constant_acceleration, generalized_alpha };

/// Contact by area where facets face each other, or the paper's fast common plane for each pair of facets.
enum class ContactModel { area, facet_wise };

enum class TimeStepControl { fixed, adaptive };

/// Newton's method on the law of contacts, or the paper's open–close iteration, which holds their states for a round.
enum class OpenCloseMethod { newton, states };

/// Inertia of static steps: falling with what is out of balance, or the paper's, all of it.
enum class StaticInertia { fading, full };

/// What Talus does beyond the equations where a scene calls for it: impacts, sleep, springs that a step can follow,
/// penalty scaling, updated normals, missed contacts, acceleration resets; or none of it.
enum class Extras { called_for, none };

/// Whether something that costs and can be left out is there: where the scene calls for it, or as the project says.
enum class Switch { called_for, on, off };

/// Talus's own scheme, or the paper's, whole: what settings are that a project leaves out.
enum class Preset { talus, paper };

/// The words the project file uses.
constexpr std::string_view to_string(Strain strain) {
  return strain == Strain::corotational ? "corotational" : "incremental";
}
constexpr std::string_view to_string(Integrator integrator) {
  switch (integrator) {
    case Integrator::newmark:
      return "newmark";
    case Integrator::constant_acceleration:
      return "constant-acceleration";
    case Integrator::generalized_alpha:
      break;
  }
  return "generalized-alpha";
}
constexpr std::string_view to_string(ContactModel model) { return model == ContactModel::area ? "area" : "facet-wise"; }
constexpr std::string_view to_string(TimeStepControl control) {
  return control == TimeStepControl::fixed ? "fixed" : "adaptive";
}
constexpr std::string_view to_string(OpenCloseMethod method) {
  return method == OpenCloseMethod::newton ? "newton" : "states";
}
constexpr std::string_view to_string(StaticInertia inertia) {
  return inertia == StaticInertia::fading ? "fading" : "full";
}
constexpr std::string_view to_string(Extras extras) { return extras == Extras::called_for ? "called_for" : "none"; }
constexpr std::string_view to_string(Switch choice) {
  switch (choice) {
    case Switch::called_for:
      return "called_for";
    case Switch::on:
      return "on";
    case Switch::off:
      break;
  }
  return "off";
}
constexpr std::string_view to_string(Preset preset) { return preset == Preset::talus ? "talus" : "paper"; }

/// How exactly a step is solved, by the names of the project file: the residual that is left over the largest force,
/// and with it what friction strengths and impulses are off by.
struct NamedTolerance {
  std::string_view name;
  double value;
};
inline constexpr NamedTolerance draft_tolerance{"draft", 1e-3}, standard_tolerance{"standard", 1e-6},
    reference_tolerance{"reference", 1e-10};
inline constexpr std::array named_tolerances{draft_tolerance, standard_tolerance, reference_tolerance};
/// Less is rounding; more would let blocks hang in the air by the work of their neighbours.
constexpr bool is_tolerance(double value) { return value >= 1e-12 && value <= 0.01; }

/// What adaptive steps keep to. Each limit makes steps shorter where it would be broken.
struct AdaptiveSteps {
  double displacement_limit = 0.005;  ///< largest displacement of a node in a step, of half the model's height
  double error_limit = 1e-4;          ///< estimated error of time integration in a step, of the smallest mesh size
  int iterations = 8;                 ///< open–close iterations above which the next step is shorter
  double shortest = 1e-3;             ///< shortest step, of the stage's time_step
  bool operator==(const AdaptiveSteps&) const = default;
};

/// What costs and can be left out, one by one. What is called for is as Extras says.
struct EffectSwitches {
  Switch contact = Switch::called_for;             ///< and all that comes of it
  Switch rebound = Switch::called_for;             ///< the law of impact
  Switch restitution = Switch::called_for;         ///< of joints, in that law
  Switch missed_contacts = Switch::called_for;     ///< detection along the way
  Switch updated_normals = Switch::called_for;     ///< of contacts that go too deep
  Switch penalty_scaling = Switch::called_for;     ///< of the same
  Switch followed_springs = Switch::called_for;    ///< no stiffer than the step can follow
  Switch acceleration_reset = Switch::called_for;  ///< after blows
  Switch sleep = Switch::called_for;
  Switch elimination = Switch::called_for;  ///< bodies that are balanced by themselves
  bool operator==(const EffectSwitches&) const = default;
};

/// Calls `visit(key, value)` for each, by the words of the project file.
void for_each_switch(auto& switches, const auto& visit) {
  visit("contact", switches.contact);
  visit("rebound", switches.rebound);
  visit("restitution", switches.restitution);
  visit("missed_contacts", switches.missed_contacts);
  visit("updated_normals", switches.updated_normals);
  visit("penalty_scaling", switches.penalty_scaling);
  visit("followed_springs", switches.followed_springs);
  visit("acceleration_reset", switches.acceleration_reset);
  visit("sleep", switches.sleep);
  visit("elimination", switches.elimination);
}

struct SolverSettings {
  Preset preset = Preset::talus;  ///< what the settings below were before a project said otherwise
  Strain strain = Strain::corotational;
  Integrator integrator = Integrator::newmark;
  double spectral_radius = 0.8;  ///< of generalized_alpha at infinite frequency, 0 … 1
  ContactModel contact = ContactModel::area;
  double contact_stiffness = 10;  ///< normal penalty in units of E*/h (docs/contact.md), dimensionless
  /// Of the mesh size: augmented Lagrangian rounds in static stages, harder springs in dynamic ones until it is met.
  /// Empty: springs as they are in static stages; in dynamic ones, where no joint has a normal stiffness of its own,
  /// StepTolerances::penetration.
  std::optional<double> penetration_tolerance;
  double tolerance = standard_tolerance.value;  ///< residual over the largest force at which a step has converged
  OpenCloseMethod open_close = OpenCloseMethod::newton;
  int open_close_limit = 160;  ///< iterations before the step is cut
  StaticInertia static_inertia = StaticInertia::fading;
  Extras extras = Extras::called_for;
  EffectSwitches effects;
  /// 1/s: blocks slower than this times their mesh size sleep in dynamic stages; 0: none. Empty:
  /// SleepTolerances::speed.
  std::optional<double> sleep_tolerance;
  bool lets_sleep() const { return !sleep_tolerance || *sleep_tolerance > 0; }
  TimeStepControl time_step_control = TimeStepControl::fixed;
  AdaptiveSteps adaptive;
  bool operator==(const SolverSettings&) const = default;
};

/// Sets what a preset decides: the scheme. Stiffness, tolerances and the length of steps stay.
void adopt(Preset preset, SolverSettings& settings);

/// The settings of a project that names a preset and says nothing else.
SolverSettings settings_of(Preset preset);

}  // namespace talus
