#include "study/accuracy/setting.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "base/error.hpp"
#include "model/number_text.hpp"
#include "model/solid_shape.hpp"
#include "model/tolerance_text.hpp"

namespace talus {

namespace {

/// Of blocks that may move.
std::optional<BodyKind> common_body(const Project& project) {
  std::optional<BodyKind> common;
  bool alike = true;
  const auto look = [&](BodyKind body) {
    if (body == BodyKind::fixed) return;
    alike = alike && common.value_or(body) == body;
    common = body;
  };
  for (const Solid& solid : project.solids) look(solid.body);
  for (const BlockOverride& block : project.blocks)
    if (block.body) look(*block.body);
  return alike ? common : std::nullopt;
}

void set_body(BodyKind& body, BodyKind wanted) {
  if (body != BodyKind::fixed) body = wanted;
}

void set_bodies(Project& project, BodyKind wanted) {
  for (Solid& solid : project.solids) set_body(solid.body, wanted);
  for (BlockOverride& block : project.blocks)
    if (block.body) set_body(*block.body, wanted);
  for (Stage& stage : project.stages)
    for (BlockChange& change : stage.blocks) set_body(change.body, wanted);
}

void scale_step(Stage& stage, double factor) {
  if (factor == 1) return;
  stage.time_step *= factor;
  if (!stage.steps) return;
  const double steps = *stage.steps / factor;
  if (steps == std::round(steps)) {
    stage.steps = static_cast<int>(steps);
  } else {
    stage.duration = steps * stage.time_step;
    stage.steps.reset();
  }
}

/// m, of the box around the shape.
double longest_side(const Solid& solid) {
  if (const auto extent = extent_of({solid})) return (extent->max - extent->min).maxCoeff();
  throw InputError("solid " + solid.name,
                   "is not made of numbers and leaves its mesh size open: it cannot be made finer",
                   "give it a mesh_size");
}

void scale_mesh(Project& project, double factor) {
  if (factor == 1) return;
  constexpr double usual = 0.1;  // of the longest side, as the mesher has it
  for (Solid& solid : project.solids)
    solid.mesh_size = factor * (solid.mesh_size ? *solid.mesh_size : usual * longest_side(solid));
  for (BlockOverride& block : project.blocks)
    if (block.mesh_size) *block.mesh_size *= factor;
}

/// "Δ/2", "4Δ".
std::string multiple(const std::string& what, double factor) {
  const double divisor = 1 / factor;
  if (factor < 1 && std::abs(divisor - std::round(divisor)) < 1e-9)
    return what + "/" + number_text(std::round(divisor));
  return number_text(factor) + what;
}

}  // namespace

Setting by_scheme(Preset scheme, Setting setting) {
  if (setting.scheme == scheme) return setting;
  const SolverSettings preset = settings_of(scheme);
  setting.scheme = scheme;
  setting.strain = preset.strain;
  setting.integrator = preset.integrator;
  setting.contact = preset.contact;
  return setting;
}

Setting own_setting(const Project& project) {
  Setting own;
  own.body = common_body(project);
  own.strain = project.solver.strain;
  own.integrator = project.solver.integrator;
  own.penetration_tolerance = project.solver.penetration_tolerance;
  own.tolerance = project.solver.tolerance;
  own.scheme = project.solver.preset;
  own.contact = project.solver.contact;
  return own;
}

Project under(const Setting& setting, const Project& given) {
  Project project = given;
  if (setting.body && setting.body != common_body(given)) set_bodies(project, *setting.body);
  if (setting.scheme != project.solver.preset) adopt(setting.scheme, project.solver);
  project.solver.strain = setting.strain;
  if (setting.integrator != project.solver.integrator)
    project.solver.spectral_radius = SolverSettings{}.spectral_radius;
  project.solver.integrator = setting.integrator;
  project.solver.penetration_tolerance = setting.penetration_tolerance;
  project.solver.tolerance = setting.tolerance;
  project.solver.contact = setting.contact;
  project.solver.contact_stiffness *= setting.contact_stiffness;
  for (Stage& stage : project.stages)
    scale_step(stage, stage.kind == StageKind::static_ ? setting.static_step : setting.time_step);
  scale_mesh(project, setting.mesh_size);
  return project;
}

std::string body_text(const Setting& setting) {
  return setting.body ? std::string(to_string(*setting.body)) : "as given";
}

std::string penetration_text(const Setting& setting) {
  return setting.penetration_tolerance ? number_text(*setting.penetration_tolerance) : "off";
}

std::string label_of(const Setting& setting, const Setting& own) {
  std::string label = body_text(setting);
  const auto add = [&](bool differs, const std::string& words) {
    if (differs) label += " · " + words;
  };
  const Setting usual = by_scheme(setting.scheme, own);
  add(setting.scheme != own.scheme, "scheme " + std::string(to_string(setting.scheme)));
  add(setting.strain != usual.strain, std::string(to_string(setting.strain)));
  add(setting.integrator != usual.integrator, std::string(to_string(setting.integrator)));
  add(setting.time_step != own.time_step, multiple("Δ", setting.time_step));
  add(setting.static_step != own.static_step, "static " + multiple("Δ", setting.static_step));
  add(setting.mesh_size != own.mesh_size, multiple("h", setting.mesh_size));
  add(setting.contact != usual.contact, "contact " + std::string(to_string(setting.contact)));
  add(setting.contact_stiffness != own.contact_stiffness, "stiffness ×" + number_text(setting.contact_stiffness));
  add(setting.penetration_tolerance != own.penetration_tolerance, "penetration " + penetration_text(setting));
  add(setting.tolerance != own.tolerance, "tolerance " + tolerance_text(setting.tolerance));
  add(setting == own, "the project's own");
  return label;
}

}  // namespace talus
