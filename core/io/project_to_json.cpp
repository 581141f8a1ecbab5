#include "io/project_to_json.hpp"

namespace talus {
namespace {

OrderedJson json_from(const Vec3& vector) { return OrderedJson::array({vector[0], vector[1], vector[2]}); }

OrderedJson json_from(const Voigt& stress) { return std::vector<double>(stress.begin(), stress.end()); }

template <typename T>
void write(OrderedJson& object, const char* key, const std::optional<T>& value) {
  if (value) object[key] = *value;
}

/// For what most projects leave as it is.
template <typename T>
void write_unless_usual(OrderedJson& object, const char* key, const T& value, const T& usual) {
  if (value != usual) object[key] = value;
}

template <typename Word>
void write_word_unless_usual(OrderedJson& object, const char* key, Word value, Word usual) {
  if (value != usual) object[key] = to_string(value);
}

OrderedJson json_from(const RockStrength& strength) {
  OrderedJson json{{"cohesion", strength.cohesion}, {"friction_angle", strength.friction_angle}};
  write(json, "tensile_strength", strength.tensile_strength);
  return json;
}

OrderedJson json_from(const Material& material) {
  OrderedJson json{{"density", material.density}, {"young", material.young}, {"poisson", material.poisson}};
  write_unless_usual(json, "damping", material.damping, 0.0);
  write_word_unless_usual(json, "law", material.law, MaterialLaw::linear);
  if (material.strength) json["strength"] = json_from(*material.strength);
  return json;
}

OrderedJson json_from(const Joint& joint) {
  OrderedJson json{{"friction_angle", joint.friction_angle}};
  write_unless_usual(json, "cohesion", joint.cohesion, 0.0);
  write_unless_usual(json, "tensile_strength", joint.tensile_strength, 0.0);
  write(json, "residual_friction_angle", joint.residual_friction_angle);
  write(json, "normal_stiffness", joint.normal_stiffness);
  write(json, "shear_stiffness", joint.shear_stiffness);
  write(json, "restitution", joint.restitution);
  return json;
}

OrderedJson json_from(const BoxShape& box) { return {{"min", json_from(box.min)}, {"max", json_from(box.max)}}; }

void write_shape(OrderedJson& solid, const BoxShape& box) { solid["box"] = json_from(box); }

void write_shape(OrderedJson& solid, const PolyhedronShape& shape) {
  auto vertices = OrderedJson::array();
  for (const auto& vertex : shape.vertices) vertices.push_back(json_from(vertex));
  solid["polyhedron"]["vertices"] = vertices;
  solid["polyhedron"]["faces"] = shape.faces;
}

void write_shape(OrderedJson& solid, const FileShape& shape) {
  solid["file"] = shape.path;
  write_unless_usual(solid, "scale", shape.scale, 1.0);
}

void write_shape(OrderedJson& solid, const TerrainShape& shape) {
  solid["terrain"] = {{"file", shape.path}, {"base", shape.base}};
  write_unless_usual(solid["terrain"], "tolerance", shape.tolerance, 0.0);
}

void write_shape(OrderedJson& solid, const CylinderShape& shape) {
  solid["cylinder"] = {{"from", json_from(shape.from)}, {"to", json_from(shape.to)}, {"radius", shape.radius}};
  write_unless_usual(solid["cylinder"], "sides", shape.sides, CylinderShape().sides);
}

void write_shape(OrderedJson& solid, const SectionShape& shape) {
  solid["section"]["points"] = shape.points;
  solid["section"]["origin"] = json_from(shape.origin);
  solid["section"]["azimuth"] = shape.azimuth;
  solid["section"]["width"] = shape.width;
}

void write_shape(OrderedJson& solid, const CombinedShape& shape) {
  solid["combine"]["operation"] = to_string(shape.operation);
  solid["combine"]["solids"] = shape.solids;
}

OrderedJson json_from(const Turn& turn) {
  return {{"axis", json_from(turn.axis)}, {"angle", turn.angle}, {"about", json_from(turn.about)}};
}

OrderedJson json_from(const Solid& solid) {
  OrderedJson json{{"name", solid.name}};
  std::visit([&](const auto& shape) { write_shape(json, shape); }, solid.shape);
  json["material"] = solid.material;
  json["body"] = to_string(solid.body);
  write(json, "mesh_size", solid.mesh_size);
  if (solid.turn) json["turn"] = json_from(*solid.turn);
  if (!solid.move.isZero(0)) json["move"] = json_from(solid.move);
  return json;
}

OrderedJson json_from(const JointNetwork& network) {
  OrderedJson json;
  json["box"] = json_from(network.box);
  json["density"] = network.density;
  json["radius"] = network.radius;
  write_word_unless_usual(json, "radius_law", network.radius_law, RadiusLaw::equal);
  write(json, "radius_deviation", network.radius_deviation);
  return json;
}

/// Where it lies: a point of a plane, or what makes it end.
void write_extent(OrderedJson& json, const Cut& cut) {
  if (cut.disc)
    json["disc"] = {{"centre", json_from(cut.disc->centre)}, {"radius", cut.disc->radius}};
  else if (cut.network)
    json["network"] = json_from(*cut.network);
  else if (cut.polygon.empty())
    json["through"] = json_from(cut.through);
  for (const Vec3& corner : cut.polygon) json["polygon"].push_back(json_from(corner));
}

OrderedJson json_from(const Cut& cut) {
  OrderedJson json{{"joint", cut.joint}, {"dip", cut.dip}, {"dip_direction", cut.dip_direction}};
  write_extent(json, cut);
  write(json, "spacing", cut.spacing);
  write(json, "count", cut.count);
  write_word_unless_usual(json, "spacing_law", cut.spacing_law, SpacingLaw::equal);
  write(json, "spacing_deviation", cut.spacing_deviation);
  write(json, "fisher_kappa", cut.fisher_kappa);
  write(json, "seed", cut.seed);
  if (!cut.ends_at.empty()) json["ends_at"] = cut.ends_at;
  if (!cut.solids.empty()) json["solids"] = cut.solids;
  return json;
}

OrderedJson json_from(const BlockOverride& block) {
  OrderedJson json{{"name", block.name}, {"at", json_from(block.at)}};
  if (block.body) json["body"] = to_string(*block.body);
  write(json, "material", block.material);
  write(json, "mesh_size", block.mesh_size);
  write_unless_usual(json, "removed", block.removed, false);
  return json;
}

OrderedJson json_from(const Merge& merge) { return {{"at", json_from(merge.at)}, {"with", json_from(merge.with)}}; }

OrderedJson json_from(const Splinters& splinters) {
  OrderedJson json;
  write(json, "thickness", splinters.thickness);
  json["rule"] = to_string(splinters.rule);
  json["chip_volume"] = splinters.chip_volume;
  return json;
}

OrderedJson json_from(const MeshRefinement& refinement) {
  OrderedJson json;
  if (refinement.face.empty()) json["at"] = json_from(refinement.at);
  for (const Vec3& corner : refinement.face) json["face"].push_back(json_from(corner));
  json["radius"] = refinement.radius;
  json["size"] = refinement.size;
  return json;
}

OrderedJson json_from(const Interface& interface) {
  OrderedJson json;
  json["between"] = interface.between;
  json["joint"] = interface.joint;
  return json;
}

OrderedJson json_from(const Constraint& constraint) {
  OrderedJson json{{"block", constraint.block}};
  if (constraint.at) json["at"] = json_from(*constraint.at);
  const auto component = [&](std::size_t i, double value) {
    return constraint.displacement[i] ? OrderedJson(value) : OrderedJson();
  };
  if (constraint.table.empty()) {
    for (std::size_t i = 0; i < 3; ++i)
      json["displacement"].push_back(component(i, constraint.displacement[i].value_or(0)));
  }
  for (const TableRow& row : constraint.table) {
    const Vec3& u = row.value;
    json["table"].push_back({row.time, component(0, u[0]), component(1, u[1]), component(2, u[2])});
  }
  return json;
}

OrderedJson json_from(const PointLoad& load) {
  OrderedJson json{{"block", load.block}, {"at", json_from(load.at)}};
  if (load.table.empty()) json["force"] = json_from(load.force);
  for (const TableRow& row : load.table) json["table"].push_back({row.time, row.value[0], row.value[1], row.value[2]});
  return json;
}

OrderedJson json_from(const InitialVelocity& velocity) {
  return {{"block", velocity.block}, {"linear", json_from(velocity.linear)}, {"angular", json_from(velocity.angular)}};
}

OrderedJson json_from(const InSituStress& in_situ) {
  OrderedJson json;
  if (!in_situ.blocks.empty()) json["blocks"] = in_situ.blocks;
  json["stress"] = json_from(in_situ.stress);
  if (in_situ.gradient != Voigt::Zero()) json["gradient"] = json_from(in_situ.gradient);
  write_unless_usual(json, "level", in_situ.level, 0.0);
  return json;
}

OrderedJson json_from(const JointChange& change) {
  auto json = OrderedJson::object();
  write(json, "friction_angle", change.friction_angle);
  write(json, "cohesion", change.cohesion);
  write(json, "tensile_strength", change.tensile_strength);
  write(json, "residual_friction_angle", change.residual_friction_angle);
  return json;
}

OrderedJson json_from(const BlockChange& change) { return {{"name", change.name}, {"body", to_string(change.body)}}; }

OrderedJson json_from(const Monitor& monitor) {
  OrderedJson json{{"name", monitor.name}, {"block", monitor.block}, {"at", json_from(monitor.at)}};
  write_unless_usual(json, "stress", monitor.stress, false);
  return json;
}

OrderedJson json_from(const Expectation& expectation) {
  OrderedJson json{{"quantity", expectation.quantity},
                   {"time", expectation.time},
                   {"value", expectation.value},
                   {"tolerance", expectation.tolerance}};
  write(json, "since", expectation.since);
  if (!expectation.source.empty()) json["source"] = expectation.source;
  return json;
}

OrderedJson json_from(const Stage& stage);  // which is in a list and holds lists

template <typename Things>
OrderedJson list_from(const Things& things) {
  auto list = OrderedJson::array();
  for (const auto& thing : things) list.push_back(json_from(thing));
  return list;
}

template <typename Things>
void write_list(OrderedJson& object, const char* key, const Things& things) {
  if (!things.empty()) object[key] = list_from(things);
}

/// An empty list is written too: it takes away what was there before.
template <typename Things>
void write_list(OrderedJson& object, const char* key, const std::optional<Things>& things) {
  if (things) object[key] = list_from(*things);
}

/// Materials and joints are objects by name.
template <typename Things>
OrderedJson by_name(const Things& things) {
  auto json = OrderedJson::object();
  for (const auto& thing : things) json[thing.name] = json_from(thing);
  return json;
}

OrderedJson json_from(const Stage& stage) {
  OrderedJson json{{"name", stage.name}, {"type", to_string(stage.kind)}, {"time_step", stage.time_step}};
  write(json, "steps", stage.steps);
  write(json, "duration", stage.duration);
  const Stage usual;
  write_unless_usual(json, "until_equilibrium", stage.until_equilibrium, usual.until_equilibrium);
  write_unless_usual(json, "equilibrium_tolerance", stage.equilibrium_tolerance, usual.equilibrium_tolerance);
  write(json, "damping", stage.damping);
  if (!stage.joints.empty()) json["joints"] = by_name(stage.joints);
  write_list(json, "loads", stage.loads);
  write_list(json, "constraints", stage.constraints);
  write_list(json, "blocks", stage.blocks);
  return json;
}

OrderedJson json_from(const AdaptiveSteps& steps) {
  const AdaptiveSteps usual;
  OrderedJson json;
  write_unless_usual(json, "displacement_limit", steps.displacement_limit, usual.displacement_limit);
  write_unless_usual(json, "error_limit", steps.error_limit, usual.error_limit);
  write_unless_usual(json, "iterations", steps.iterations, usual.iterations);
  write_unless_usual(json, "shortest", steps.shortest, usual.shortest);
  return json;
}

OrderedJson json_from(const EffectSwitches& switches) {
  OrderedJson json;
  for_each_switch(switches, [&](const char* key, Switch choice) {
    write_word_unless_usual(json, key, choice, Switch::called_for);
  });
  return json;
}

/// By its name, where it has one.
OrderedJson tolerance_json(double tolerance) {
  for (const auto& [name, value] : named_tolerances)
    if (tolerance == value) return name;
  return tolerance;
}

OrderedJson json_from(const SolverSettings& solver) {
  const SolverSettings usual = settings_of(solver.preset);
  OrderedJson json = OrderedJson::object();
  write_word_unless_usual(json, "preset", solver.preset, Preset::talus);
  if (json.empty() || solver.strain != usual.strain) json["strain"] = to_string(solver.strain);
  write_word_unless_usual(json, "integrator", solver.integrator, usual.integrator);
  write_unless_usual(json, "spectral_radius", solver.spectral_radius, usual.spectral_radius);
  write_word_unless_usual(json, "contact", solver.contact, usual.contact);
  write_unless_usual(json, "contact_stiffness", solver.contact_stiffness, usual.contact_stiffness);
  write(json, "penetration_tolerance", solver.penetration_tolerance);
  if (solver.tolerance != usual.tolerance) json["tolerance"] = tolerance_json(solver.tolerance);
  write_word_unless_usual(json, "open_close", solver.open_close, usual.open_close);
  write_unless_usual(json, "open_close_limit", solver.open_close_limit, usual.open_close_limit);
  write_word_unless_usual(json, "static_inertia", solver.static_inertia, usual.static_inertia);
  write_word_unless_usual(json, "extras", solver.extras, usual.extras);
  if (solver.effects != usual.effects) json["effects"] = json_from(solver.effects);
  write(json, "sleep_tolerance", solver.sleep_tolerance);
  write_word_unless_usual(json, "time_step_control", solver.time_step_control, usual.time_step_control);
  if (solver.adaptive != usual.adaptive) json["adaptive"] = json_from(solver.adaptive);
  return json;
}

OrderedJson json_from(const MeshSettings& mesh) {
  OrderedJson json = OrderedJson::object();
  write(json, "size", mesh.size);
  write_list(json, "refinements", mesh.refinements);
  write_unless_usual(json, "most_tetrahedra", mesh.most_tetrahedra, MeshSettings().most_tetrahedra);
  return json;
}

}  // namespace

OrderedJson project_to_json(const Project& project) {
  OrderedJson json{{"talus", 1}};
  if (!project.name.empty()) json["name"] = project.name;
  json["gravity"] = json_from(project.gravity);
  if (!project.origin.isZero(0)) json["origin"] = json_from(project.origin);
  json["materials"] = by_name(project.materials);  // also when empty, as the schema asks
  if (!project.joints.empty()) json["joints"] = by_name(project.joints);
  if (!project.default_joint.empty()) json["default_joint"] = project.default_joint;
  write_list(json, "solids", project.solids);
  write_list(json, "cuts", project.cuts);
  write_list(json, "blocks", project.blocks);
  write_list(json, "merges", project.merges);
  if (project.splinters != Splinters()) json["splinters"] = json_from(project.splinters);
  if (project.mesh != MeshSettings()) json["mesh"] = json_from(project.mesh);
  write_list(json, "interfaces", project.interfaces);
  write_list(json, "constraints", project.constraints);
  write_list(json, "loads", project.loads);
  write_list(json, "velocities", project.velocities);
  write_list(json, "in_situ", project.in_situ);
  write_list(json, "stages", project.stages);
  if (project.solver != SolverSettings()) json["solver"] = json_from(project.solver);
  write_list(json, "monitors", project.monitors);
  write_list(json, "expect", project.expect);
  if (project.output != Output()) json["output"]["every"] = project.output.every;
  return json;
}

}  // namespace talus
