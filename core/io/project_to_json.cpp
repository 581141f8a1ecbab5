#include "io/project_to_json.hpp"

namespace talus {
namespace {

OrderedJson json_from(const Vec3& vector) { return OrderedJson::array({vector[0], vector[1], vector[2]}); }

template <typename T>
void write(OrderedJson& object, const char* key, const std::optional<T>& value) {
  if (value) object[key] = *value;
}

OrderedJson json_from(const Material& material) {
  return {{"density", material.density}, {"young", material.young}, {"poisson", material.poisson}};
}

OrderedJson json_from(const Joint& joint) {
  OrderedJson json{{"friction_angle", joint.friction_angle},
                   {"cohesion", joint.cohesion},
                   {"tensile_strength", joint.tensile_strength}};
  write(json, "residual_friction_angle", joint.residual_friction_angle);
  write(json, "normal_stiffness", joint.normal_stiffness);
  write(json, "shear_stiffness", joint.shear_stiffness);
  return json;
}

void write_shape(OrderedJson& solid, const BoxShape& box) {
  solid["box"] = {{"min", json_from(box.min)}, {"max", json_from(box.max)}};
}

void write_shape(OrderedJson& solid, const PolyhedronShape& shape) {
  auto vertices = OrderedJson::array();
  for (const auto& vertex : shape.vertices) vertices.push_back(json_from(vertex));
  solid["polyhedron"]["vertices"] = vertices;
  solid["polyhedron"]["faces"] = shape.faces;
}

void write_shape(OrderedJson& solid, const FileShape& shape) {
  solid["file"] = shape.path;
  solid["scale"] = shape.scale;
}

OrderedJson json_from(const Solid& solid) {
  OrderedJson json{{"name", solid.name}};
  std::visit([&](const auto& shape) { write_shape(json, shape); }, solid.shape);
  json["material"] = solid.material;
  json["body"] = to_string(solid.body);
  write(json, "mesh_size", solid.mesh_size);
  return json;
}

OrderedJson json_from(const Cut& cut) {
  OrderedJson json{{"joint", cut.joint},
                   {"dip", cut.dip},
                   {"dip_direction", cut.dip_direction},
                   {"through", json_from(cut.through)}};
  write(json, "spacing", cut.spacing);
  write(json, "count", cut.count);
  if (!cut.solids.empty()) json["solids"] = cut.solids;
  return json;
}

OrderedJson json_from(const BlockOverride& block) {
  OrderedJson json{{"name", block.name}, {"at", json_from(block.at)}};
  if (block.body) json["body"] = to_string(*block.body);
  write(json, "material", block.material);
  write(json, "mesh_size", block.mesh_size);
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
  for (const auto& component : constraint.displacement) {
    json["displacement"].push_back(component ? OrderedJson(*component) : OrderedJson());
  }
  return json;
}

OrderedJson json_from(const PointLoad& load) {
  return {{"block", load.block}, {"at", json_from(load.at)}, {"force", json_from(load.force)}};
}

OrderedJson json_from(const InitialVelocity& velocity) {
  return {{"block", velocity.block}, {"linear", json_from(velocity.linear)}, {"angular", json_from(velocity.angular)}};
}

OrderedJson json_from(const Stage& stage) {
  OrderedJson json{{"name", stage.name}, {"type", to_string(stage.kind)}, {"time_step", stage.time_step}};
  write(json, "steps", stage.steps);
  write(json, "duration", stage.duration);
  return json;
}

OrderedJson json_from(const SolverSettings& solver) {
  return {{"strain", to_string(solver.strain)},
          {"integrator", to_string(solver.integrator)},
          {"contact_stiffness", solver.contact_stiffness},
          {"open_close_limit", solver.open_close_limit}};
}

OrderedJson json_from(const Monitor& monitor) {
  return {{"name", monitor.name}, {"block", monitor.block}, {"at", json_from(monitor.at)}};
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

template <typename Things>
void write_list(OrderedJson& object, const char* key, const Things& things) {
  for (const auto& thing : things) object[key].push_back(json_from(thing));
}

/// Materials and joints are objects by name; materials are there even when empty, as the schema asks.
template <typename Things>
OrderedJson by_name(const Things& things) {
  auto json = OrderedJson::object();
  for (const auto& thing : things) json[thing.name] = json_from(thing);
  return json;
}

}  // namespace

OrderedJson project_to_json(const Project& project) {
  OrderedJson json{{"talus", 1}};
  if (!project.name.empty()) json["name"] = project.name;
  json["gravity"] = json_from(project.gravity);
  json["materials"] = by_name(project.materials);
  if (!project.joints.empty()) json["joints"] = by_name(project.joints);
  if (!project.default_joint.empty()) json["default_joint"] = project.default_joint;
  write_list(json, "solids", project.solids);
  write_list(json, "cuts", project.cuts);
  write_list(json, "blocks", project.blocks);
  write_list(json, "interfaces", project.interfaces);
  write_list(json, "constraints", project.constraints);
  write_list(json, "loads", project.loads);
  write_list(json, "velocities", project.velocities);
  write_list(json, "stages", project.stages);
  json["solver"] = json_from(project.solver);
  write_list(json, "monitors", project.monitors);
  write_list(json, "expect", project.expect);
  json["output"]["every"] = project.output.every;
  return json;
}

}  // namespace talus
