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
          keep(std::make_unique<CorotationalElasticity>(set_, tolerances_));
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
      case EffectKind::damping:
        if (std::vector<double> rates = damping_rates(project_, system_, project_.stages[stage_]);
            *std::max_element(rates.begin(), rates.end()) > 0)
          keep(std::make_unique<Damping>(set_, std::move(rates)));
        break;
      default:
        break;  // of contact, or no term of the potential
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
  const EffectTolerances& tolerances_;
  Composition composition_;
};

/// A kind's place in the sum of all effects.
template <class Made>
Made* put(Composition& composition, std::unique_ptr<Made> effect, PutIn& where) {
  Made* made = effect.get();
  auto& effects = composition.effects;
  const auto place =
      std::find_if(effects.begin(), effects.end(), [&](const auto& other) { return other->kind() > made->kind(); });
  if (where.count++ == 0) where.place = static_cast<int>(place - effects.begin());
  effects.insert(place, std::move(effect));
  return made;
}

}  // namespace

Composition compose(const Project& project, const BlockSystem& system, int stage, BodySet& set,
                    const ContactLinks& links, const EffectTolerances& tolerances, bool with_contact) {
  StageEffects effects(project, system, stage, set, links, tolerances);
  for (const EffectStatus& status : called_effects(project, system))
    if (status.active) effects.add(status.kind);
  Composition composition = effects.take();
  if (with_contact) put_in_contact(composition, project, system, tolerances);
  return composition;
}

PutIn put_in_contact(Composition& composition, const Project& project, const BlockSystem& system,
                     const EffectTolerances& tolerances) {
  PutIn where;
  const ContactLinks& links = *composition.links;
  const auto put_in_normal = [&](NormalContact::Points points) {
    composition.normal.push_back(put(composition, std::make_unique<NormalContact>(links, points, tolerances), where));
  };
  for (const EffectStatus& status : called_effects(project, system)) {
    if (!status.active) continue;
    if (status.kind == EffectKind::normal_contact) put_in_normal(NormalContact::Points::loose);
    if (status.kind == EffectKind::shear_contact)
      composition.shear = put(composition, std::make_unique<ShearContact>(links, tolerances), where);
    if (status.kind == EffectKind::cohesion_and_tension) put_in_normal(NormalContact::Points::bonded);
    if (status.kind == EffectKind::rebound) composition.rebounds = true;
  }
  return where;
}

}  // namespace talus
