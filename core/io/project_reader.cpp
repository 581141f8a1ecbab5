#include "io/project_reader.hpp"

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

BodyKind body_from(const OrderedJson& value) {
  for (const auto kind : {BodyKind::fixed, BodyKind::rigid, BodyKind::affine}) {
    if (value.get<std::string>() == to_string(kind)) return kind;
  }
  return BodyKind::tetrahedra;
}

Material material_from(const std::string& name, const OrderedJson& value) {
  Material material{.name = name};
  read(value, "density", material.density);
  read(value, "young", material.young);
  read(value, "poisson", material.poisson);
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

Solid read_item(const OrderedJson& value, Solid solid) {
  read(value, "name", solid.name);
  if (value.contains("box")) {
    solid.shape = BoxShape{vector_from(value.at("box").at("min")), vector_from(value.at("box").at("max"))};
  } else if (value.contains("polyhedron")) {
    solid.shape = polyhedron_from(value.at("polyhedron"));
  } else {
    solid.shape = file_from(value);
  }
  read(value, "material", solid.material);
  if (value.contains("body")) solid.body = body_from(value.at("body"));
  read(value, "mesh_size", solid.mesh_size);
  return solid;
}

Cut read_item(const OrderedJson& value, Cut cut) {
  read(value, "joint", cut.joint);
  read(value, "dip", cut.dip);
  read(value, "dip_direction", cut.dip_direction);
  read(value, "through", cut.through);
  read(value, "spacing", cut.spacing);
  read(value, "count", cut.count);
  read(value, "solids", cut.solids);
  return cut;
}

BlockOverride read_item(const OrderedJson& value, BlockOverride block) {
  read(value, "name", block.name);
  read(value, "at", block.at);
  if (value.contains("body")) block.body = body_from(value.at("body"));
  read(value, "material", block.material);
  read(value, "mesh_size", block.mesh_size);
  return block;
}

Interface read_item(const OrderedJson& value, Interface interface) {
  read(value, "between", interface.between);
  read(value, "joint", interface.joint);
  return interface;
}

Constraint read_item(const OrderedJson& value, Constraint constraint) {
  read(value, "block", constraint.block);
  if (value.contains("at")) read(value, "at", constraint.at.emplace());
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
  return load;
}

InitialVelocity read_item(const OrderedJson& value, InitialVelocity velocity) {
  read(value, "block", velocity.block);
  read(value, "linear", velocity.linear);
  read(value, "angular", velocity.angular);
  return velocity;
}

Stage read_item(const OrderedJson& value, Stage stage) {
  read(value, "name", stage.name);
  stage.kind =
      value.at("type").get<std::string>() == to_string(StageKind::static_) ? StageKind::static_ : StageKind::dynamic;
  read(value, "time_step", stage.time_step);
  read(value, "steps", stage.steps);
  read(value, "duration", stage.duration);
  return stage;
}

Monitor read_item(const OrderedJson& value, Monitor monitor) {
  read(value, "name", monitor.name);
  read(value, "block", monitor.block);
  read(value, "at", monitor.at);
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

/// The one of `choices` whose word the value is.
template <typename Choice>
void read_word(const OrderedJson& object, const char* key, Choice& choice, std::initializer_list<Choice> choices) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  for (const Choice candidate : choices)
    if (to_string(candidate) == found->get<std::string>()) choice = candidate;
}

SolverSettings solver_from(const OrderedJson& value) {
  SolverSettings solver;
  read_word(value, "strain", solver.strain, {Strain::corotational, Strain::incremental});
  read_word(value, "integrator", solver.integrator,
            {Integrator::newmark, Integrator::constant_acceleration, Integrator::generalized_alpha});
  read(value, "contact_stiffness", solver.contact_stiffness);
  read(value, "open_close_limit", solver.open_close_limit);
  return solver;
}

template <typename T>
void read_list(const OrderedJson& object, const char* key, std::vector<T>& list) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  for (const auto& item : *found) list.push_back(read_item(item, T{}));
}

}  // namespace

Project project_from_json(const OrderedJson& value) {
  Project project;
  read(value, "name", project.name);
  read(value, "gravity", project.gravity);
  for (const auto& [name, material] : value.at("materials").items()) {
    project.materials.push_back(material_from(name, material));
  }
  if (value.contains("joints")) {
    for (const auto& [name, joint] : value.at("joints").items()) project.joints.push_back(joint_from(name, joint));
  }
  read(value, "default_joint", project.default_joint);
  read_list(value, "solids", project.solids);
  read_list(value, "cuts", project.cuts);
  read_list(value, "blocks", project.blocks);
  read_list(value, "interfaces", project.interfaces);
  read_list(value, "constraints", project.constraints);
  read_list(value, "loads", project.loads);
  read_list(value, "velocities", project.velocities);
  read_list(value, "stages", project.stages);
  if (value.contains("solver")) project.solver = solver_from(value.at("solver"));
  read_list(value, "monitors", project.monitors);
  read_list(value, "expect", project.expect);
  if (value.contains("output")) read(value.at("output"), "every", project.output.every);
  return project;
}

}  // namespace talus
