#include "study/accuracy/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "base/error.hpp"
#include "model/number_text.hpp"
#include "model/rules/validate.hpp"
#include "model/tolerance_text.hpp"

namespace talus {

namespace {

using Values = std::vector<std::string>;

constexpr StudyAxis all_axes[] = {StudyAxis::body,
                                  StudyAxis::strain,
                                  StudyAxis::integrator,
                                  StudyAxis::time_step,
                                  StudyAxis::static_step,
                                  StudyAxis::mesh_size,
                                  StudyAxis::contact,
                                  StudyAxis::contact_stiffness,
                                  StudyAxis::penetration_tolerance,
                                  StudyAxis::tolerance,
                                  StudyAxis::scheme};

Values usual_values(StudyAxis axis) {
  switch (axis) {
    case StudyAxis::body:
      return {"rigid", "affine", "tetrahedra"};
    case StudyAxis::strain:
      return {"corotational", "incremental"};
    case StudyAxis::integrator:
      return {"newmark", "constant-acceleration", "generalized-alpha"};
    case StudyAxis::time_step:
      return {"4", "2", "1", "0.5", "0.25"};
    case StudyAxis::static_step:
      return {"1", "0.5"};
    case StudyAxis::mesh_size:
      return {"2", "1", "0.5"};
    case StudyAxis::contact:
      return {"area", "facet-wise"};
    case StudyAxis::contact_stiffness:
      return {"0.5", "1", "2"};
    case StudyAxis::penetration_tolerance:
      return {"off", "1e-3", "1e-4"};
    case StudyAxis::tolerance:
      return {"draft", "standard", "reference"};
    case StudyAxis::scheme:
      break;
  }
  return {"talus", "paper"};
}

Values split(const std::string& text) {
  Values words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

InputError no_such_value(StudyAxis axis, const std::string& word, const std::string& remedy) {
  return InputError("axis " + std::string(to_string(axis)), "'" + word + "' is none of its values", remedy);
}

StudyAxis axis_named(const std::string& word) {
  std::string known;
  for (const StudyAxis axis : all_axes) {
    if (to_string(axis) == word) return axis;
    (known += known.empty() ? "" : ", ") += to_string(axis);
  }
  throw InputError("axis '" + word + "'", "there is none of that name", "choose among " + known);
}

double positive_number(StudyAxis axis, const std::string& word) {
  std::size_t end = 0;
  double value = 0;
  try {
    value = std::stod(word, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  if (end == 0 || end != word.size() || !std::isfinite(value) || value <= 0)
    throw no_such_value(axis, word, "write a number above 0, like 0.5");
  return value;
}

double tolerance_of(StudyAxis axis, const std::string& word) {
  if (const auto tolerance = tolerance_from(word)) return *tolerance;
  throw no_such_value(axis, word, "write draft, standard, reference, or a number from 1e-12 to 0.01");
}

template <typename Kind>
Kind kind_named(StudyAxis axis, const std::string& word, std::initializer_list<Kind> kinds) {
  for (const Kind kind : kinds)
    if (to_string(kind) == word) return kind;
  std::string known;
  for (const Kind kind : kinds) (known += known.empty() ? "" : ", ") += to_string(kind);
  throw no_such_value(axis, word, "choose among " + known);
}

void set(Setting& setting, StudyAxis axis, const std::string& word) {
  switch (axis) {
    case StudyAxis::body:
      setting.body =
          kind_named(axis, word, {BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra, BodyKind::automatic});
      break;
    case StudyAxis::strain:
      setting.strain = kind_named(axis, word, {Strain::corotational, Strain::incremental});
      break;
    case StudyAxis::integrator:
      setting.integrator = kind_named(
          axis, word, {Integrator::newmark, Integrator::constant_acceleration, Integrator::generalized_alpha});
      break;
    case StudyAxis::time_step:
      setting.time_step = positive_number(axis, word);
      break;
    case StudyAxis::static_step:
      setting.static_step = positive_number(axis, word);
      break;
    case StudyAxis::mesh_size:
      setting.mesh_size = positive_number(axis, word);
      break;
    case StudyAxis::contact:
      setting.contact = kind_named(axis, word, {ContactModel::area, ContactModel::facet_wise});
      break;
    case StudyAxis::contact_stiffness:
      setting.contact_stiffness = positive_number(axis, word);
      break;
    case StudyAxis::penetration_tolerance:
      setting.penetration_tolerance = word == "off" ? std::nullopt : std::optional<double>(positive_number(axis, word));
      break;
    case StudyAxis::tolerance:
      setting.tolerance = tolerance_of(axis, word);
      break;
    case StudyAxis::scheme:
      setting = by_scheme(kind_named(axis, word, {Preset::talus, Preset::paper}), setting);
      break;
  }
}

bool deforms_by_its_mesh(const Setting& setting) {
  return setting.body != BodyKind::rigid && setting.body != BodyKind::affine;
}

/// Why no value of the axis can change this project's answer; empty where some may.
std::string reason_against(StudyAxis axis, const Project& project) {
  const Setting own = own_setting(project);
  const auto has = [&](StageKind kind) {
    return std::any_of(project.stages.begin(), project.stages.end(), [&](const Stage& s) { return s.kind == kind; });
  };
  switch (axis) {
    case StudyAxis::integrator:
    case StudyAxis::time_step:
      if (!has(StageKind::dynamic)) return "no stage is dynamic";
      break;
    case StudyAxis::static_step:
      if (!has(StageKind::static_)) return "no stage is static";
      break;
    case StudyAxis::strain:
      if (own.body == BodyKind::rigid) return "rigid blocks have no strain";
      break;
    case StudyAxis::mesh_size:
      if (!deforms_by_its_mesh(own)) return body_text(own) + " blocks do not deform by their mesh";
      break;
    case StudyAxis::contact_stiffness:
      if (!project.joints.empty() && std::all_of(project.joints.begin(), project.joints.end(), [](const Joint& joint) {
            return joint.normal_stiffness && joint.shear_stiffness;
          }))
        return "every joint has stiffnesses of its own";
      [[fallthrough]];
    case StudyAxis::contact:
    case StudyAxis::penetration_tolerance:
      if (project.solids.size() == 1 && project.cuts.empty()) return "there is one block, and nothing it could touch";
      break;
    case StudyAxis::body:
    case StudyAxis::tolerance:
    case StudyAxis::scheme:
      break;
  }
  return {};
}

/// Why a setting makes no sense for the project; empty where it does.
std::string reason_against(const Setting& setting, const Project& project) {
  if (setting.mesh_size != 1 && !deforms_by_its_mesh(setting)) return "these blocks do not deform by their mesh";
  if (setting.body == BodyKind::rigid && !project.in_situ.empty()) return "rigid blocks bear no stress in situ";
  try {
    validate(under(setting, project));
  } catch (const InputError& error) {
    return error.problem();
  }
  return {};
}

/// Builds a ladder rung by rung, each setting once.
class LadderBuilder {
 public:
  LadderBuilder(const Project& project, const LadderWish& wish) : project_(project), own_(own_setting(project)) {
    add(own_);
    const auto& asked = wish.axes;
    for (const StudyAxis axis : all_axes) {
      if (!asked.empty() && std::find(asked.begin(), asked.end(), axis) == asked.end()) continue;
      const auto given = wish.values.find(axis);
      const Values values = given == wish.values.end() ? usual_values(axis) : given->second;
      const std::string reason = reason_against(axis, project_);
      if (reason.empty())
        add_axis(axis, values);
      else
        ladder_.left_out.push_back({std::string(to_string(axis)), reason});
    }
  }

  Ladder build() {
    add_cheap_ones();
    add_unlike_ones();
    ladder_.finest = add(finest());
    if (ladder_.finest < 0) ladder_.finest = 0;
    return std::move(ladder_);
  }

 private:
  /// Its place in the ladder; −1 where it was left out.
  int add(const Setting& setting) {
    auto& settings = ladder_.settings;
    const auto found = std::find(settings.begin(), settings.end(), setting);
    if (found != settings.end()) return static_cast<int>(found - settings.begin());
    if (const std::string reason = settings.empty() ? "" : reason_against(setting, project_); !reason.empty()) {
      ladder_.left_out.push_back({label_of(setting, own_), reason});
      return -1;
    }
    settings.push_back(setting);
    return static_cast<int>(settings.size()) - 1;
  }

  void add_axis(StudyAxis axis, const Values& values) {
    for (const std::string& word : values) {
      Setting setting = own_;
      set(setting, axis, word);
      if (add(setting) >= 0) taken_[axis].push_back(setting);
    }
  }

  /// The smallest or largest factor taken on an axis; the project's own where there is none.
  double factor(StudyAxis axis, bool smallest) const {
    double best = 1;
    if (const auto found = taken_.find(axis); found != taken_.end())
      for (const Setting& setting : found->second)
        best = smallest ? std::min(best, size_on(axis, setting)) : std::max(best, size_on(axis, setting));
    return best;
  }

  /// What an engineer tries first: few degrees of freedom with long steps, and mesh and steps coarser together.
  void add_cheap_ones() {
    const double coarse_step = factor(StudyAxis::time_step, false), coarse_mesh = factor(StudyAxis::mesh_size, false);
    if (coarse_step > 1)
      for (Setting setting : taken_[StudyAxis::body]) {
        setting.time_step = coarse_step;
        if (!deforms_by_its_mesh(setting)) add(setting);
      }
    if (coarse_step > 1 && coarse_mesh > 1) {
      Setting setting = own_;
      setting.time_step = coarse_step;
      setting.mesh_size = coarse_mesh;
      add(setting);
    }
  }

  /// Coarse on one axis and fine on another: whether errors add up, and which of them a single body has.
  void add_unlike_ones() {
    const double long_step = factor(StudyAxis::time_step, false), short_step = factor(StudyAxis::time_step, true);
    const double coarse = factor(StudyAxis::mesh_size, false), fine = factor(StudyAxis::mesh_size, true);
    if (short_step < 1)
      for (Setting setting : taken_[StudyAxis::body]) {
        setting.time_step = short_step;
        if (!deforms_by_its_mesh(setting)) add(setting);
      }
    const auto add_own_body = [&](double step, double mesh) {
      Setting setting = own_;
      setting.time_step = step;
      setting.mesh_size = mesh;
      if (step != 1 && mesh != 1) add(setting);
    };
    add_own_body(long_step, fine);
    add_own_body(short_step, coarse);
  }

  /// Finest on every axis that has fineness; strain, integrator, contact and scheme stay the project's own.
  Setting finest() const {
    Setting setting = own_;
    if (const auto bodies = taken_.find(StudyAxis::body); bodies != taken_.end())
      for (const Setting& one : bodies->second)
        if (one.body == BodyKind::tetrahedra) setting.body = one.body;
    setting.time_step = factor(StudyAxis::time_step, true);
    setting.contact_stiffness = 1 / factor(StudyAxis::contact_stiffness, true);
    if (deforms_by_its_mesh(setting)) setting.mesh_size = factor(StudyAxis::mesh_size, true);
    if (const auto tolerances = taken_.find(StudyAxis::penetration_tolerance); tolerances != taken_.end())
      for (const Setting& one : tolerances->second)
        if (one.penetration_tolerance)
          setting.penetration_tolerance =
              std::min(setting.penetration_tolerance.value_or(*one.penetration_tolerance), *one.penetration_tolerance);
    if (const auto tolerances = taken_.find(StudyAxis::tolerance); tolerances != taken_.end())
      for (const Setting& one : tolerances->second) setting.tolerance = std::min(setting.tolerance, one.tolerance);
    return setting;
  }

  const Project& project_;
  const Setting own_;
  std::map<StudyAxis, std::vector<Setting>> taken_;
  Ladder ladder_;
};

}  // namespace

double size_on(StudyAxis axis, const Setting& setting) {
  if (axis == StudyAxis::mesh_size) return setting.mesh_size;
  if (axis == StudyAxis::contact_stiffness) return 1 / setting.contact_stiffness;
  return axis == StudyAxis::time_step ? setting.time_step : setting.static_step;
}

void set_own_size(StudyAxis axis, Setting& setting) {
  if (axis == StudyAxis::mesh_size) setting.mesh_size = 1;
  if (axis == StudyAxis::time_step) setting.time_step = 1;
  if (axis == StudyAxis::static_step) setting.static_step = 1;
  if (axis == StudyAxis::contact_stiffness) setting.contact_stiffness = 1;
}

LadderWish parse_ladder_wish(const std::vector<std::string>& axes, const std::vector<std::string>& values) {
  LadderWish wish;
  for (const std::string& list : axes)
    for (const std::string& word : split(list)) wish.axes.push_back(axis_named(word));
  for (const std::string& text : values) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals + 1 == text.size())
      throw InputError("values '" + text + "'", "is no axis with values", "write them like time_step=4,2,1,0.5");
    const StudyAxis axis = axis_named(text.substr(0, equals));
    wish.values[axis] = split(text.substr(equals + 1));
    if (std::find(wish.axes.begin(), wish.axes.end(), axis) == wish.axes.end()) wish.axes.push_back(axis);
  }
  return wish;
}

Ladder make_ladder(const Project& project, const LadderWish& wish) { return LadderBuilder(project, wish).build(); }

double relative_cost(const Setting& setting) {
  constexpr double tetrahedra_by_size = 3.5;  // power: their number, and equations that grow a little faster
  constexpr double as_single_body = 0.05;
  const double block = deforms_by_its_mesh(setting) ? std::pow(setting.mesh_size, -tetrahedra_by_size) : as_single_body;
  return block / setting.time_step;
}

}  // namespace talus
