#include "effects/compose.hpp"

#include <algorithm>

#include "effects/body_force.hpp"
#include "effects/displacement_constraint.hpp"
#include "effects/elasticity.hpp"
#include "effects/inertia.hpp"
#include "effects/initial_stress.hpp"
#include "effects/point_load.hpp"

namespace talus {

namespace {

/// Springs that hold a point are this many times stiffer than the rock around it, E·h [N/m].
constexpr double constraint_stiffness = 100;
/// A point of a load or a constraint may lie outside its block by this much of the block's size.
constexpr double point_tolerance = 1e-6;

std::string count(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

double block_size(const Block& block) { return std::cbrt(block.volume); }

const Block& block_named(const BlockSystem& system, const std::string& name) {
  const auto found =
      std::find_if(system.blocks.begin(), system.blocks.end(), [&](const Block& b) { return b.name == name; });
  return found == system.blocks.end() ? system.blocks.front() : *found;
}

std::vector<LoadedPoint> loaded_points(const Project& project, const BlockSystem& system) {
  std::vector<LoadedPoint> loads;
  for (std::size_t i = 0; i < project.loads.size(); ++i) {
    const PointLoad& load = project.loads[i];
    const double tolerance = point_tolerance * block_size(block_named(system, load.block));
    loads.push_back(
        {material_point(system, load.block, load.at, tolerance, "/loads/" + std::to_string(i)), load.force});
  }
  return loads;
}

std::vector<HeldPoint> held_points(const Project& project, const BlockSystem& system) {
  std::vector<HeldPoint> points;
  for (std::size_t i = 0; i < project.constraints.size(); ++i) {
    const Constraint& constraint = project.constraints[i];
    if (!constraint.at) continue;
    const Block& block = block_named(system, constraint.block);
    const double size = block_size(block);
    const MaterialPoint point = material_point(system, constraint.block, *constraint.at, point_tolerance * size,
                                               "/constraints/" + std::to_string(i));
    points.push_back(
        {point, constraint.displacement, constraint_stiffness * project.materials[block.material].young * size});
  }
  return points;
}

std::string joints_where(const Project& project, bool (*resists)(const Joint&)) {
  std::string names;
  for (const Joint& joint : project.joints)
    if (resists(joint)) names += (names.empty() ? "" : ", ") + joint.name;
  return names;
}

}  // namespace

std::vector<EffectStatus> called_effects(const Project& project, const BlockSystem& system) {
  const auto movable = static_cast<std::size_t>(std::count_if(
      system.blocks.begin(), system.blocks.end(), [](const Block& b) { return b.body != BodyKind::fixed; }));
  const bool touching = movable > 0 && system.blocks.size() > 1;
  const std::string shear =
      joints_where(project, [](const Joint& j) { return j.friction_angle > 0 || j.cohesion > 0; });
  const std::string bonds =
      joints_where(project, [](const Joint& j) { return j.cohesion > 0 || j.tensile_strength > 0; });
  const bool any_static = std::any_of(project.stages.begin(), project.stages.end(),
                                      [](const Stage& s) { return s.kind == StageKind::static_; });
  const auto choose = [](bool active, const std::string& on, const std::string& off) { return active ? on : off; };
  std::vector<EffectStatus> list;
  const auto add = [&](const char* name, bool active, const std::string& on, const std::string& off) {
    list.push_back({name, active, choose(active, on, off)});
  };
  add("elasticity", movable > 0, count(movable, "block deforms", "blocks deform"), "every block is fixed");
  add("initial stress", movable > 0, "stress is carried from step to step", "every block is fixed");
  add("inertia", movable > 0,
      any_static ? "always; static stages start every step at rest" : "always; the velocity is carried on",
      "every block is fixed");
  add("displacement constraint", !project.constraints.empty(),
      count(project.constraints.size(), "point is held", "points are held"), "no point is held");
  add("point load", !project.loads.empty(), count(project.loads.size(), "load", "loads"), "no point load");
  add("body force", movable > 0 && project.gravity.norm() > 0, "gravity", "no gravity");
  add("normal contact", touching, count(system.blocks.size(), "block", "blocks") + " can touch", "nothing can touch");
  add("shear contact", touching && !shear.empty(), "friction or cohesion on " + shear, "no joint resists shear");
  add("cohesion and tension", touching && !bonds.empty(), "bonds on " + bonds,
      "no joint has cohesion or tensile strength");
  add("damping", false, "", "no stage or material asks for it");
  return list;
}

Composition compose(const Project& project, const BlockSystem& system, BodySet& set, const ContactSet& contacts) {
  Composition composition;
  for (const EffectStatus& status : called_effects(project, system)) {
    if (!status.active) continue;
    auto& effects = composition.effects;
    if (status.name == "elasticity") effects.push_back(std::make_unique<Elasticity>(set));
    if (status.name == "initial stress") effects.push_back(std::make_unique<InitialStress>(set));
    if (status.name == "inertia") effects.push_back(std::make_unique<Inertia>(set));
    if (status.name == "displacement constraint")
      effects.push_back(std::make_unique<DisplacementConstraints>(set, held_points(project, system)));
    if (status.name == "point load")
      effects.push_back(std::make_unique<PointLoads>(set, loaded_points(project, system)));
    if (status.name == "body force") effects.push_back(std::make_unique<BodyForce>(set, project.gravity));
    if (status.name == "normal contact") {
      auto normal = std::make_unique<NormalContact>(set, contacts);
      composition.normal = normal.get();
      effects.push_back(std::move(normal));
    }
    if (status.name == "shear contact") {
      auto shear = std::make_unique<ShearContact>(set, contacts);
      composition.shear = shear.get();
      effects.push_back(std::move(shear));
    }
  }
  return composition;
}

}  // namespace talus
