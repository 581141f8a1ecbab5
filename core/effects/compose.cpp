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

std::vector<LoadedPoint> loaded_points(const Project& project, const BlockSystem& system, const Place& list,
                                       const EffectTolerances& tolerances) {
  std::vector<LoadedPoint> loads;
  for (std::size_t i = 0; i < project.loads.size(); ++i) {
    const PointLoad& load = project.loads[i];
    const double tolerance = tolerances.point_outside_block * block_size(block_named(system, load.block));
    loads.push_back(
        {material_point(system, load.block, load.at, tolerance, (list / i).text()), load.force, load.table});
  }
  return loads;
}

std::vector<HeldPoint> held_points(const Project& project, const BlockSystem& system, const Place& list,
                                   const EffectTolerances& tolerances) {
  std::vector<HeldPoint> points;
  for (std::size_t i = 0; i < project.constraints.size(); ++i) {
    const Constraint& constraint = project.constraints[i];
    if (!constraint.at) continue;
    const Block& block = block_named(system, constraint.block);
    const double size = block_size(block);
    const MaterialPoint point = material_point(system, constraint.block, *constraint.at,
                                               tolerances.point_outside_block * size, (list / i).text());
    points.push_back({point, constraint.displacement,
                      tolerances.constraint_stiffness * project.materials[block.material].young * size,
                      constraint.table});
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

/// Builds the effects of a stage, a kind at a time.
class StageEffects {
 public:
  StageEffects(const Project& project, const BlockSystem& system, int stage, BodySet& set, const ContactLinks& links,
               const EffectTolerances& tolerances)
      : project_(project),
        system_(system),
        stage_(stage),
        now_(project_in_stage(project, stage)),
        set_(set),
        links_(links),
        tolerances_(tolerances) {
    composition_.bodies = &set;
    composition_.links = &links;
  }

  /// A kind that some stage calls for; this one may not.
  void add(EffectKind kind) {
    const bool corotational = project_.solver.strain == Strain::corotational;
    switch (kind) {
      case EffectKind::elasticity:
        if (corotational)
          keep(std::make_unique<CorotationalElasticity>(set_));
        else
          keep(std::make_unique<Elasticity>(set_));
        break;
      case EffectKind::neo_hookean_elasticity:
        keep(std::make_unique<NeoHookeanElasticity>(set_, tolerances_));
        break;
      case EffectKind::initial_stress:
        if (corotational)
          keep(std::make_unique<InSituStresses>(project_, system_, set_));
        else
          keep(std::make_unique<InitialStress>(set_));
        break;
      case EffectKind::inertia:
        composition_.inertia = keep(std::make_unique<Inertia>(set_));
        break;
      case EffectKind::displacement_constraint:
        if (holds_points(now_))
          keep(std::make_unique<DisplacementConstraints>(
              set_, held_points(now_, system_, place_of_constraints(project_, stage_), tolerances_)));
        break;
      case EffectKind::point_load:
        if (!now_.loads.empty())
          keep(std::make_unique<PointLoads>(
              set_, loaded_points(now_, system_, place_of_loads(project_, stage_), tolerances_)));
        break;
      case EffectKind::body_force:
        keep(std::make_unique<BodyForce>(set_, project_.gravity));
        break;
      case EffectKind::normal_contact:
        composition_.normal.push_back(
            keep(std::make_unique<NormalContact>(links_, NormalContact::Points::loose, tolerances_)));
        break;
      case EffectKind::shear_contact:
        composition_.shear = keep(std::make_unique<ShearContact>(links_, tolerances_));
        break;
      case EffectKind::cohesion_and_tension:
        composition_.normal.push_back(
            keep(std::make_unique<NormalContact>(links_, NormalContact::Points::bonded, tolerances_)));
        break;
      case EffectKind::rebound:
        composition_.rebounds = true;
        break;
      case EffectKind::damping:
        if (std::vector<double> rates = damping_rates(project_, system_, project_.stages[stage_]);
            *std::max_element(rates.begin(), rates.end()) > 0)
          keep(std::make_unique<Damping>(set_, std::move(rates)));
        break;
    }
  }

  Composition take() { return std::move(composition_); }

 private:
  template <class Kept>
  Kept* keep(std::unique_ptr<Kept> effect) {
    Kept* kept = effect.get();
    composition_.effects.push_back(std::move(effect));
    return kept;
  }

  const Project& project_;
  const BlockSystem& system_;
  const int stage_;
  const Project now_;  ///< as it holds in the stage
  BodySet& set_;
  const ContactLinks& links_;
  const EffectTolerances& tolerances_;
  Composition composition_;
};

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
  const auto add = [&](EffectKind kind, bool active, const std::string& on, const std::string& off) {
    list.push_back({kind, active, active ? on : off});
  };
  const auto resists = [](const Joint& j) { return j.friction_angle > 0 || j.cohesion > 0; };
  const auto bonds = [](const Joint& j) { return j.cohesion > 0 || j.tensile_strength > 0; };
  const auto rebounds = [](const Joint& j) { return j.restitution.has_value(); };
  const std::string frame = corotational ? ", measured in the rotated frame" : ", summed up step by step";
  const std::string still = "every block is fixed";
  const std::string stiff = movable == 0 ? still : "every block that moves is rigid";
  add(EffectKind::elasticity, linear > 0, count(linear, "block deforms", "blocks deform") + frame,
      deformable == 0 ? stiff : "every block that deforms is neo-Hookean");
  add(EffectKind::neo_hookean_elasticity, neo_hookean > 0,
      count(neo_hookean, "block deforms", "blocks deform") + " by that law", "no material that deforms asks for it");
  add(EffectKind::initial_stress, deformable > 0 && (!corotational || !project.in_situ.empty()),
      corotational ? "stress in situ" : "stress is carried from step to step",
      deformable == 0 ? stiff : "no stress in situ; corotational strain carries none from step to step");
  const auto any_stage = [&](StageKind kind) {
    return std::any_of(project.stages.begin(), project.stages.end(), [=](const Stage& s) { return s.kind == kind; });
  };
  add(EffectKind::inertia, movable > 0,
      any_stage(StageKind::static_) ? "always; static stages start every step at rest"
                                    : "always; the velocity is carried on",
      still);
  add(EffectKind::displacement_constraint, in_any_stage(project, holds_points), "points are held", "no point is held");
  add(EffectKind::point_load, in_any_stage(project, [](const Project& p) { return !p.loads.empty(); }),
      "forces on points", "no point load");
  add(EffectKind::body_force, movable > 0 && project.gravity.norm() > 0, "gravity", "no gravity");
  add(EffectKind::normal_contact, touching, count(system.blocks.size(), "block", "blocks") + " can touch",
      "nothing can touch");
  const auto any_joint = [&](bool (*has)(const Joint&)) {
    return in_any_stage(project, [&](const Project& p) { return std::any_of(p.joints.begin(), p.joints.end(), has); });
  };
  add(EffectKind::shear_contact, touching && any_joint(resists),
      "friction or cohesion on " + joints_where(project, resists), "no joint resists shear");
  add(EffectKind::cohesion_and_tension, touching && any_joint(bonds), "bonds on " + joints_where(project, bonds),
      "no joint has cohesion or tensile strength");
  const bool given = any_joint(rebounds), moves = any_stage(StageKind::dynamic);
  const bool extras = project.solver.extras == Extras::called_for;
  add(EffectKind::rebound, extras && touching && moves && (given || rigid > 0),
      given
          ? "restitution of " + joints_where(project, rebounds)
          : count(rigid, "rigid block stays", "rigid blocks stay") + " where a contact too stiff for the step stops it",
      !extras     ? "the settings ask for nothing beyond the equations"
      : !touching ? "nothing can touch"
      : !moves    ? "every stage is static"
                  : "no restitution given, and no block is rigid");
  add(EffectKind::damping, movable > 0 && damps(project), "a stage or a material asks for it",
      "no stage or material asks for it");
  return list;
}

Composition compose(const Project& project, const BlockSystem& system, int stage, BodySet& set,
                    const ContactLinks& links, const EffectTolerances& tolerances) {
  StageEffects effects(project, system, stage, set, links, tolerances);
  for (const EffectStatus& status : called_effects(project, system))
    if (status.active) effects.add(status.kind);
  return effects.take();
}

}  // namespace talus
