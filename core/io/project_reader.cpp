#include "io/project_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace talus {
namespace {

Vec3 vector_from(const OrderedJson& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

/// Sets `target` where `object` has the key.
template <typename T>
void read(const OrderedJson& object, const char* key, T& target) {
  if (const auto found = object.find(key); found != object.end()) target = found->get<T>();
}

template <typename T>
void read(const OrderedJson& object, const char* key, std::optional<T>& target) {
  if (const auto found = object.find(key); found != object.end()) target = found->get<T>();
}

void read(const OrderedJson& object, const char* key, Vec3& target) {
  if (const auto found = object.find(key); found != object.end()) target = vector_from(*found);
}

void read(const OrderedJson& object, const char* key, Voigt& target) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  for (std::size_t i = 0; i < 6; ++i) target[static_cast<Eigen::Index>(i)] = found->at(i).get<double>();
}

/// The one of `choices` whose word the value is.
template <typename Choice>
void read_word(const OrderedJson& object, const char* key, Choice& choice, std::initializer_list<Choice> choices) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  for (const Choice candidate : choices) {
    if (to_string(candidate) == found->get<std::string>()) choice = candidate;
  }
}

void read_body(const OrderedJson& object, BodyKind& body) {
  read_word(object, "body", body,
            {BodyKind::fixed, BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra, BodyKind::automatic});
}

/// Materials and joints are members of an object, by their names.
template <typename T>
void read_by_name(const OrderedJson& object, const char* key, std::vector<T>& list,
                  T (*item_from)(const std::string&, const OrderedJson&)) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  for (const auto& [name, item] : found->items()) list.push_back(item_from(name, item));
}

void read(const OrderedJson& object, const char* key, std::optional<RockStrength>& target) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  RockStrength& strength = target.emplace();
  read(*found, "cohesion", strength.cohesion);
  read(*found, "friction_angle", strength.friction_angle);
  read(*found, "tensile_strength", strength.tensile_strength);
}

Material material_from(const std::string& name, const OrderedJson& value) {
  Material material{.name = name};
  read(value, "density", material.density);
  read(value, "young", material.young);
  read(value, "poisson", material.poisson);
  read(value, "damping", material.damping);
  read(value, "strength", material.strength);
  read_word(value, "law", material.law, {MaterialLaw::linear, MaterialLaw::neo_hookean});
  return material;
}

Joint joint_from(const std::string& name, const OrderedJson& value) {
  Joint joint;
  joint.name = name;
  read(value, "friction_angle", joint.friction_angle);
  read(value, "cohesion", joint.cohesion);
  read(value, "tensile_strength", joint.tensile_strength);
  read(value, "residual_friction_angle", joint.residual_friction_angle);
  read(value, "normal_stiffness", joint.normal_stiffness);
  read(value, "shear_stiffness", joint.shear_stiffness);
  read(value, "restitution", joint.restitution);
  return joint;
}

PolyhedronShape polyhedron_from(const OrderedJson& value) {
  PolyhedronShape shape;
  for (const auto& vertex : value.at("vertices")) shape.vertices.push_back(vector_from(vertex));
  shape.faces = value.at("faces").get<std::vector<std::vector<int>>>();
  return shape;
}

FileShape file_from(const OrderedJson& solid) {
  FileShape shape;
  read(solid, "file", shape.path);
  read(solid, "scale", shape.scale);
  return shape;
}

BoxShape box_from(const OrderedJson& value) { return {vector_from(value.at("min")), vector_from(value.at("max"))}; }

TerrainShape terrain_from(const OrderedJson& value) {
  TerrainShape shape;
  read(value, "file", shape.path);
  read(value, "base", shape.base);
  read(value, "tolerance", shape.tolerance);
  return shape;
}

CylinderShape cylinder_from(const OrderedJson& value) {
  CylinderShape shape;
  read(value, "from", shape.from);
  read(value, "to", shape.to);
  read(value, "radius", shape.radius);
  read(value, "sides", shape.sides);
  return shape;
}

SectionShape section_from(const OrderedJson& value) {
  SectionShape shape;
  read(value, "points", shape.points);
  read(value, "origin", shape.origin);
  read(value, "azimuth", shape.azimuth);
  read(value, "width", shape.width);
  return shape;
}

CombinedShape combined_from(const OrderedJson& value) {
  CombinedShape shape;
  read_word(value, "operation", shape.operation,
            {CombineOperation::unite, CombineOperation::subtract, CombineOperation::intersect});
  read(value, "solids", shape.solids);
  return shape;
}

SolidShape shape_from(const OrderedJson& solid) {
  if (solid.contains("box")) return box_from(solid.at("box"));
  if (solid.contains("polyhedron")) return polyhedron_from(solid.at("polyhedron"));
  if (solid.contains("terrain")) return terrain_from(solid.at("terrain"));
  if (solid.contains("cylinder")) return cylinder_from(solid.at("cylinder"));
  if (solid.contains("section")) return section_from(solid.at("section"));
  if (solid.contains("combine")) return combined_from(solid.at("combine"));
  return file_from(solid);
}

Turn turn_from(const OrderedJson& value) {
  Turn turn;
  read(value, "axis", turn.axis);
  read(value, "angle", turn.angle);
  read(value, "about", turn.about);
  return turn;
}

Solid read_item(const OrderedJson& value, Solid solid) {
  read(value, "name", solid.name);
  solid.shape = shape_from(value);
  read(value, "material", solid.material);
  read_body(value, solid.body);
  read(value, "mesh_size", solid.mesh_size);
  if (value.contains("turn")) solid.turn = turn_from(value.at("turn"));
  read(value, "move", solid.move);
  return solid;
}

Disc disc_from(const OrderedJson& value) {
  Disc disc;
  read(value, "centre", disc.centre);
  read(value, "radius", disc.radius);
  return disc;
}

JointNetwork network_from(const OrderedJson& value) {
  JointNetwork network;
  network.box = box_from(value.at("box"));
  read(value, "density", network.density);
  read(value, "radius", network.radius);
  read_word(value, "radius_law", network.radius_law, {RadiusLaw::equal, RadiusLaw::exponential, RadiusLaw::lognormal});
  read(value, "radius_deviation", network.radius_deviation);
  return network;
}

/// What makes the cut end, and with it the point that it goes through.
void read_ends(const OrderedJson& value, Cut& cut) {
  if (value.contains("disc")) {
    cut.disc = disc_from(value.at("disc"));
    cut.through = cut.disc->centre;
  }
  if (value.contains("polygon")) {
    for (const auto& corner : value.at("polygon")) cut.polygon.push_back(vector_from(corner));
    cut.through = std::accumulate(cut.polygon.begin(), cut.polygon.end(), Vec3(Vec3::Zero())) /
                  static_cast<double>(cut.polygon.size());
  }
  if (value.contains("network")) {
    cut.network = network_from(value.at("network"));
    cut.through = (cut.network->box.min + cut.network->box.max) / 2;
  }
  read(value, "ends_at", cut.ends_at);
}

Cut read_item(const OrderedJson& value, Cut cut) {
  read(value, "joint", cut.joint);
  read(value, "dip", cut.dip);
  read(value, "dip_direction", cut.dip_direction);
  read(value, "through", cut.through);
  read(value, "spacing", cut.spacing);
  read(value, "count", cut.count);
  read(value, "solids", cut.solids);
  read_word(value, "spacing_law", cut.spacing_law,
            {SpacingLaw::equal, SpacingLaw::normal, SpacingLaw::exponential, SpacingLaw::lognormal});
  read(value, "spacing_deviation", cut.spacing_deviation);
  read(value, "fisher_kappa", cut.fisher_kappa);
  read(value, "seed", cut.seed);
  read_ends(value, cut);
  return cut;
}

BlockOverride read_item(const OrderedJson& value, BlockOverride block) {
  read(value, "name", block.name);
  read(value, "at", block.at);
  if (value.contains("body")) read_body(value, block.body.emplace());
  read(value, "material", block.material);
  read(value, "mesh_size", block.mesh_size);
  read(value, "removed", block.removed);
  return block;
}

Merge read_item(const OrderedJson& value, Merge merge) {
  read(value, "at", merge.at);
  read(value, "with", merge.with);
  return merge;
}

Splinters splinters_from(const OrderedJson& value) {
  Splinters splinters;
  read(value, "thickness", splinters.thickness);
  read(value, "chip_volume", splinters.chip_volume);
  read_word(value, "rule", splinters.rule, {SplinterRule::refuse, SplinterRule::drop, SplinterRule::merge});
  return splinters;
}

MeshRefinement read_item(const OrderedJson& value, MeshRefinement refinement) {
  read(value, "at", refinement.at);
  if (value.contains("face"))
    for (const auto& corner : value.at("face")) refinement.face.push_back(vector_from(corner));
  read(value, "radius", refinement.radius);
  read(value, "size", refinement.size);
  return refinement;
}

Interface read_item(const OrderedJson& value, Interface interface) {
  read(value, "between", interface.between);
  read(value, "joint", interface.joint);
  return interface;
}

/// A number where there is none is found out by the rules: NaN.
double number_from(const OrderedJson& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

TimeTable table_from(const OrderedJson& value) {
  TimeTable table;
  for (const auto& row : value) {
    table.push_back({number_from(row.at(0)), {number_from(row.at(1)), number_from(row.at(2)), number_from(row.at(3))}});
  }
  return table;
}

/// A component is free that no row gives.
void read_moves(const OrderedJson& value, Constraint& constraint) {
  constraint.table = table_from(value);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto is_free = [&](const TableRow& row) { return std::isnan(row.value[i]); };
    if (!std::all_of(constraint.table.begin(), constraint.table.end(), is_free)) continue;
    constraint.displacement[static_cast<std::size_t>(i)].reset();
    for (auto& row : constraint.table) row.value[i] = 0;
  }
}

Constraint read_item(const OrderedJson& value, Constraint constraint) {
  read(value, "block", constraint.block);
  if (value.contains("at")) read(value, "at", constraint.at.emplace());
  if (value.contains("table")) {
    read_moves(value.at("table"), constraint);
    return constraint;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& component = value.at("displacement").at(i);
    constraint.displacement[i] = component.is_null() ? std::nullopt : std::optional(component.get<double>());
  }
  return constraint;
}

PointLoad read_item(const OrderedJson& value, PointLoad load) {
  read(value, "block", load.block);
  read(value, "at", load.at);
  read(value, "force", load.force);
  if (value.contains("table")) load.table = table_from(value.at("table"));
  return load;
}

InitialVelocity read_item(const OrderedJson& value, InitialVelocity velocity) {
  read(value, "block", velocity.block);
  read(value, "linear", velocity.linear);
  read(value, "angular", velocity.angular);
  return velocity;
}

InSituStress read_item(const OrderedJson& value, InSituStress in_situ) {
  read(value, "blocks", in_situ.blocks);
  read(value, "stress", in_situ.stress);
  read(value, "gradient", in_situ.gradient);
  read(value, "level", in_situ.level);
  return in_situ;
}

JointChange joint_change_from(const std::string& name, const OrderedJson& value) {
  JointChange change;
  change.name = name;
  read(value, "friction_angle", change.friction_angle);
  read(value, "residual_friction_angle", change.residual_friction_angle);
  read(value, "cohesion", change.cohesion);
  read(value, "tensile_strength", change.tensile_strength);
  return change;
}

BlockChange read_item(const OrderedJson& value, BlockChange change) {
  read(value, "name", change.name);
  read_body(value, change.body);
  return change;
}

Monitor read_item(const OrderedJson& value, Monitor monitor) {
  read(value, "name", monitor.name);
  read(value, "block", monitor.block);
  read(value, "at", monitor.at);
  read(value, "stress", monitor.stress);
  return monitor;
}

Expectation read_item(const OrderedJson& value, Expectation expectation) {
  read(value, "quantity", expectation.quantity);
  read(value, "time", expectation.time);
  read(value, "value", expectation.value);
  read(value, "tolerance", expectation.tolerance);
  read(value, "since", expectation.since);
  read(value, "source", expectation.source);
  return expectation;
}

Stage read_item(const OrderedJson& value, Stage stage);  // which is in a list and holds lists

template <typename T>
void read_list(const OrderedJson& object, const char* key, std::vector<T>& list) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  for (const auto& item : *found) list.push_back(read_item(item, T{}));
}

template <typename T>
void read_list(const OrderedJson& object, const char* key, std::optional<std::vector<T>>& list) {
  if (object.contains(key)) read_list(object, key, list.emplace());
}

Stage read_item(const OrderedJson& value, Stage stage) {
  read(value, "name", stage.name);
  read_word(value, "type", stage.kind, {StageKind::static_, StageKind::dynamic});
  read(value, "time_step", stage.time_step);
  read(value, "steps", stage.steps);
  read(value, "duration", stage.duration);
  read(value, "until_equilibrium", stage.until_equilibrium);
  read(value, "equilibrium_tolerance", stage.equilibrium_tolerance);
  read(value, "damping", stage.damping);
  read_by_name(value, "joints", stage.joints, joint_change_from);
  read_list(value, "loads", stage.loads);
  read_list(value, "constraints", stage.constraints);
  read_list(value, "blocks", stage.blocks);
  return stage;
}

AdaptiveSteps adaptive_from(const OrderedJson& value) {
  AdaptiveSteps steps;
  read(value, "displacement_limit", steps.displacement_limit);
  read(value, "error_limit", steps.error_limit);
  read(value, "iterations", steps.iterations);
  read(value, "shortest", steps.shortest);
  return steps;
}

EffectSwitches effect_switches_from(const OrderedJson& value) {
  EffectSwitches switches;
  for_each_switch(switches, [&](const char* key, Switch& choice) {
    read_word(value, key, choice, {Switch::called_for, Switch::on, Switch::off});
  });
  return switches;
}

/// A number, or the name of one.
void read_tolerance(const OrderedJson& object, double& tolerance) {
  const auto found = object.find("tolerance");
  if (found == object.end()) return;
  if (found->is_number()) tolerance = found->get<double>();
  for (const auto& [name, value] : named_tolerances)
    if (*found == name) tolerance = value;
}

SolverSettings solver_from(const OrderedJson& value) {
  Preset preset = Preset::talus;
  read_word(value, "preset", preset, {Preset::talus, Preset::paper});
  SolverSettings solver = settings_of(preset);
  read_word(value, "strain", solver.strain, {Strain::corotational, Strain::incremental});
  read_word(value, "integrator", solver.integrator,
            {Integrator::newmark, Integrator::constant_acceleration, Integrator::generalized_alpha});
  read(value, "spectral_radius", solver.spectral_radius);
  read_word(value, "contact", solver.contact, {ContactModel::area, ContactModel::facet_wise});
  read(value, "contact_stiffness", solver.contact_stiffness);
  read(value, "penetration_tolerance", solver.penetration_tolerance);
  read_tolerance(value, solver.tolerance);
  read_word(value, "open_close", solver.open_close, {OpenCloseMethod::newton, OpenCloseMethod::states});
  read(value, "open_close_limit", solver.open_close_limit);
  read_word(value, "static_inertia", solver.static_inertia, {StaticInertia::fading, StaticInertia::full});
  read_word(value, "extras", solver.extras, {Extras::called_for, Extras::none});
  if (value.contains("effects")) solver.effects = effect_switches_from(value.at("effects"));
  read(value, "sleep_tolerance", solver.sleep_tolerance);
  read_word(value, "time_step_control", solver.time_step_control, {TimeStepControl::fixed, TimeStepControl::adaptive});
  if (value.contains("adaptive")) solver.adaptive = adaptive_from(value.at("adaptive"));
  return solver;
}

MeshSettings mesh_from(const OrderedJson& value) {
  MeshSettings mesh;
  read(value, "size", mesh.size);
  read_list(value, "refinements", mesh.refinements);
  read(value, "most_tetrahedra", mesh.most_tetrahedra);
  return mesh;
}

}  // namespace

Project project_from_json(const OrderedJson& value) {
  Project project;
  read(value, "name", project.name);
  read(value, "gravity", project.gravity);
  read(value, "origin", project.origin);
  read_by_name(value, "materials", project.materials, material_from);
  read_by_name(value, "joints", project.joints, joint_from);
  read(value, "default_joint", project.default_joint);
  read_list(value, "solids", project.solids);
  read_list(value, "cuts", project.cuts);
  read_list(value, "blocks", project.blocks);
  read_list(value, "merges", project.merges);
  if (value.contains("splinters")) project.splinters = splinters_from(value.at("splinters"));
  if (value.contains("mesh")) project.mesh = mesh_from(value.at("mesh"));
  read_list(value, "interfaces", project.interfaces);
  read_list(value, "constraints", project.constraints);
  read_list(value, "loads", project.loads);
  read_list(value, "velocities", project.velocities);
  read_list(value, "in_situ", project.in_situ);
  read_list(value, "stages", project.stages);
  if (value.contains("solver")) project.solver = solver_from(value.at("solver"));
  read_list(value, "monitors", project.monitors);
  read_list(value, "expect", project.expect);
  if (value.contains("output")) read(value.at("output"), "every", project.output.every);
  return project;
}

}  // namespace talus
