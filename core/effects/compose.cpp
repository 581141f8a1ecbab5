#include "effects/compose.hpp"

#include <algorithm>

#include "effects/body_force.hpp"
#include "effects/corotational_elasticity.hpp"
#include "effects/damping.hpp"
#include "effects/displacement_constraint.hpp"
#include "effects/elasticity.hpp"
#include "effects/in_situ_stress.hpp"
#include "effects/inertia.hpp"
#include "effects/initial_stress.hpp"
#include "effects/neo_hookean_elasticity.hpp"
#include "effects/point_load.hpp"
#include "model/stage_changes.hpp"

namespace talus {

namespace {

/// Springs that hold a point are this many times stiffer than the rock around it, E·h [N/m].
constexpr double constraint_stiffness = 100;
/// A point of a load or a constraint may lie outside its block by this much of the block's size.
constexpr double point_tolerance = 1e-6;

std::string count(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

bool deforms(const Block& block) { return block.body == BodyKind::affine || block.body == BodyKind::tetrahedra; }

std::size_t deforming_blocks(const Project& project, const BlockSystem& system, MaterialLaw law) {
  return static_cast<std::size_t>(std::count_if(system.blocks.begin(), system.blocks.end(), [&](const Block& block) {
    return deforms(block) && project.materials[block.material].law == law;
  }));
}

double block_size(const Block& block) { return std::cbrt(block.volume); }

const Block& block_named(const BlockSystem& system, const std::string& name) {
  const auto found =
      std::find_if(system.blocks.begin(), system.blocks.end(), [&](const Block& b) { return b.name == name; });
  return found == system.blocks.end() ? system.blocks.front() : *found;
}

std::vector<LoadedPoint> loaded_points(const Project& project, const BlockSystem& system, const Place& list) {
  std::vector<LoadedPoint> loads;
  for (std::size_t i = 0; i < project.loads.size(); ++i) {
    const PointLoad& load = project.loads[i];
    const double tolerance = point_tolerance * block_size(block_named(system, load.block));
    loads.push_back(
        {material_point(system, load.block, load.at, tolerance, (list / i).text()), load.force, load.table});
  }
  return loads;
}

std::vector<HeldPoint> held_points(const Project& project, const BlockSystem& system, const Place& list) {
  std::vector<HeldPoint> points;
  for (std::size_t i = 0; i < project.constraints.size(); ++i) {
    const Constraint& constraint = project.constraints[i];
    if (!constraint.at) continue;
    const Block& block = block_named(system, constraint.block);
    const double size = block_size(block);
    const MaterialPoint point =
        material_point(system, constraint.block, *constraint.at, point_tolerance * size, (list / i).text());
    points.push_back({point, constraint.displacement,
                      constraint_stiffness * project.materials[block.material].young * size, constraint.table});
  }
  return points;
}

std::string joints_where(const Project& project, bool (*resists)(const Joint&)) {
  std::string names;
  for (const Joint& joint : project.joints)
    if (resists(joint)) names += (names.empty() ? "" : ", ") + joint.name;
  return names;
}

/// All stages' projects in one: an effect is on if any stage calls for it.
template <class Calls>
bool in_any_stage(const Project& project, Calls calls) {
  for (int stage = 0; stage < static_cast<int>(project.stages.size()); ++stage)
    if (calls(project_in_stage(project, stage))) return true;
  return calls(project);
}

bool holds_points(const Project& project) {
  return std::any_of(project.constraints.begin(), project.constraints.end(),
                     [](const Constraint& c) { return c.at.has_value(); });
}

bool damps(const Project& project) {
  return std::any_of(project.materials.begin(), project.materials.end(),
                     [](const Material& m) { return m.damping > 0; }) ||
         std::any_of(project.stages.begin(), project.stages.end(),
                     [](const Stage& s) { return s.damping.value_or(0) > 0; });
}

std::vector<double> damping_rates(const Project& project, const BlockSystem& system, const Stage& stage) {
  std::vector<double> rates;
  for (const Block& block : system.blocks)
    rates.push_back(project.materials[block.material].damping + stage.damping.value_or(0));
  return rates;
}

}  // namespace

std::vector<EffectStatus> called_effects(const Project& project, const BlockSystem& system) {
  const auto movable = static_cast<std::size_t>(std::count_if(
      system.blocks.begin(), system.blocks.end(), [](const Block& b) { return b.body != BodyKind::fixed; }));
  const std::size_t linear = deforming_blocks(project, system, MaterialLaw::linear);
  const std::size_t neo_hookean = deforming_blocks(project, system, MaterialLaw::neo_hookean);
  const std::size_t deformable = linear + neo_hookean, rigid = movable - deformable;
  const bool touching = movable > 0 && system.blocks.size() > 1;
  const bool corotational = project.solver.strain == Strain::corotational;
  std::vector<EffectStatus> list;
  const auto add = [&](const char* name, bool active, const std::string& on, const std::string& off) {
    list.push_back({name, active, active ? on : off});
  };
  const auto resists = [](const Joint& j) { return j.friction_angle > 0 || j.cohesion > 0; };
  const auto bonds = [](const Joint& j) { return j.cohesion > 0 || j.tensile_strength > 0; };
  const auto rebounds = [](const Joint& j) { return j.restitution.has_value(); };
  const std::string frame = corotational ? ", measured in the rotated frame" : ", summed up step by step";
  const std::string still = "every block is fixed";
  const std::string stiff = movable == 0 ? still : "every block that moves is rigid";
  add("elasticity", linear > 0, count(linear, "block deforms", "blocks deform") + frame,
      deformable == 0 ? stiff : "every block that deforms is neo-Hookean");
  add("neo-Hookean elasticity", neo_hookean > 0, count(neo_hookean, "block deforms", "blocks deform") + " by that law",
      "no material that deforms asks for it");
  add("initial stress", deformable > 0 && (!corotational || !project.in_situ.empty()),
      corotational ? "stress in situ" : "stress is carried from step to step",
      deformable == 0 ? stiff : "no stress in situ; corotational strain carries none from step to step");
  const auto any_stage = [&](StageKind kind) {
    return std::any_of(project.stages.begin(), project.stages.end(), [=](const Stage& s) { return s.kind == kind; });
  };
  add("inertia", movable > 0,
      any_stage(StageKind::static_) ? "always; static stages start every step at rest"
                                    : "always; the velocity is carried on",
      still);
  add("displacement constraint", in_any_stage(project, holds_points), "points are held", "no point is held");
  add("point load", in_any_stage(project, [](const Project& p) { return !p.loads.empty(); }), "forces on points",
      "no point load");
  add("body force", movable > 0 && project.gravity.norm() > 0, "gravity", "no gravity");
  add("normal contact", touching, count(system.blocks.size(), "block", "blocks") + " can touch", "nothing can touch");
  const auto any_joint = [&](bool (*has)(const Joint&)) {
    return in_any_stage(project, [&](const Project& p) { return std::any_of(p.joints.begin(), p.joints.end(), has); });
  };
  add("shear contact", touching && any_joint(resists), "friction or cohesion on " + joints_where(project, resists),
      "no joint resists shear");
  add("cohesion and tension", touching && any_joint(bonds), "bonds on " + joints_where(project, bonds),
      "no joint has cohesion or tensile strength");
  const bool given = any_joint(rebounds), moves = any_stage(StageKind::dynamic);
  add("rebound", touching && moves && (given || rigid > 0),
      given
          ? "restitution of " + joints_where(project, rebounds)
          : count(rigid, "rigid block stays", "rigid blocks stay") + " where a contact too stiff for the step stops it",
      !touching ? "nothing can touch"
      : !moves  ? "every stage is static"
                : "no restitution given, and no block is rigid");
  add("damping", movable > 0 && damps(project), "a stage or a material asks for it",
      "no stage or material asks for it");
  return list;
}

Composition compose(const Project& project, const BlockSystem& system, int stage, BodySet& set,
                    const ContactLinks& links) {
  Composition composition;
  composition.bodies = &set;
  composition.links = &links;
  auto& effects = composition.effects;
  const auto add = [&](auto effect) {
    auto* kept = effect.get();
    effects.push_back(std::move(effect));
    return kept;
  };
  const Project now = project_in_stage(project, stage);
  const bool corotational = project.solver.strain == Strain::corotational;
  for (const EffectStatus& status : called_effects(project, system)) {
    if (!status.active) continue;
    if (status.name == "elasticity" && corotational) add(std::make_unique<CorotationalElasticity>(set));
    if (status.name == "elasticity" && !corotational) add(std::make_unique<Elasticity>(set));
    if (status.name == "neo-Hookean elasticity") add(std::make_unique<NeoHookeanElasticity>(set));
    if (status.name == "initial stress" && corotational) add(std::make_unique<InSituStresses>(project, system, set));
    if (status.name == "initial stress" && !corotational) add(std::make_unique<InitialStress>(set));
    if (status.name == "inertia") composition.inertia = add(std::make_unique<Inertia>(set));
    if (status.name == "displacement constraint" && holds_points(now))
      add(std::make_unique<DisplacementConstraints>(set,
                                                    held_points(now, system, place_of_constraints(project, stage))));
    if (status.name == "point load" && !now.loads.empty())
      add(std::make_unique<PointLoads>(set, loaded_points(now, system, place_of_loads(project, stage))));
    if (status.name == "body force") add(std::make_unique<BodyForce>(set, project.gravity));
    if (status.name == "normal contact")
      composition.normal.push_back(add(std::make_unique<NormalContact>(links, NormalContact::Points::loose)));
    if (status.name == "cohesion and tension")
      composition.normal.push_back(add(std::make_unique<NormalContact>(links, NormalContact::Points::bonded)));
    if (status.name == "rebound") composition.rebounds = true;
    if (status.name == "shear contact") composition.shear = add(std::make_unique<ShearContact>(links));
    const std::vector<double> rates = damping_rates(project, system, project.stages[stage]);
    if (status.name == "damping" && *std::max_element(rates.begin(), rates.end()) > 0)
      add(std::make_unique<Damping>(set, rates));
  }
  return composition;
}

}  // namespace talus
