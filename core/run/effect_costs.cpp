#include "run/effect_costs.hpp"

#include <algorithm>

#include "contact/contact_point.hpp"
#include "effects/called_effects.hpp"
#include "model/number_text.hpp"
#include "model/stage_changes.hpp"
#include "solve/company.hpp"
#include "solve/simulation.hpp"

namespace talus {

namespace {

/// Seconds an effect spends on one thing in an open–close iteration.
/// EffectOutcome::seconds over iterations and things, on one core of about 3 GHz. Elements with corotational strain,
/// their inertia and weight, and contact points: as the samples jiweishan, step_slope and block_ladder spend them,
/// where the sums of all effects then agree within 15 %. The others: cubes on a fixed slab with 100 loads and 100 held
/// points, measured with other work on the machine and scaled down by what the first came to be less without it. An
/// iteration evaluates an effect three to six times, and assembles its stiffness once where it changes with the
/// increment.
namespace unit_cost {
constexpr double corotational_element = 1.9e-6;
constexpr double neo_hookean_element = 1.3e-6;  // 0.45 to 0.8 of a corotational one in the same scene
constexpr double incremental_element = 0.9e-6;
constexpr double stress_in_situ_of_element = 0.45e-6;
constexpr double carried_stress_of_element = 0.19e-6;
constexpr double inertia_of_element = 0.075e-6;
constexpr double inertia_of_rigid = 0.4e-6;
constexpr double weight = 0.022e-6;
constexpr double damping_of_element = 0.05e-6;
constexpr double damping_of_rigid = 0.3e-6;
constexpr double normal_point = 0.13e-6;
constexpr double shear_point = 0.13e-6;
constexpr double bonded_point = 0.13e-6;
/// Once a step, divided among its iterations. Where blocks rest 0.02 µs; where they fall onto each other 0.14 to
/// 0.4, in a row of dominoes 1.2: in proportion to normal contact's in the same hard cases.
constexpr double rebound_point = 0.2e-6;
/// Not in every iteration either, divided among them: in proportion to normal contact's where 105 blocks slide, 76
/// stand and 100 pour, and within a factor of ten there. Of a step in which blocks turn, missed contacts cost as much
/// as finding the contacts.
constexpr double missed_contact_point = 0.06e-6;
constexpr double updated_normal_point = 0.007e-6;
constexpr double scaled_point = 0.001e-6;
constexpr double followed_point = 0.002e-6;
constexpr double eliminated_point = 0.005e-6;
/// In proportion to inertia's in the same runs.
constexpr double reset_of_body = 0.06e-6;
constexpr double sleep_of_block = 0.01e-6;
constexpr double held_point = 0.3e-6;
constexpr double load = 0.2e-6;
}  // namespace unit_cost

struct Items {
  long count = 0;
  const char *one = "", *many = "";
  double unit = 0;  ///< s an iteration, of one
};

/// The most of a kind that any stage has.
template <class Count>
long most_in_a_stage(const Project& project, const Count& count) {
  long most = 0;
  for (std::size_t s = 0; s < project.stages.size(); ++s)
    most = std::max(most, static_cast<long>(count(project_in_stage(project, static_cast<int>(s)))));
  return most;
}

long held_points(const Project& project) {
  return std::count_if(project.constraints.begin(), project.constraints.end(),
                       [](const Constraint& c) { return c.at.has_value(); });
}

std::vector<Items> elements(long tetrahedra, long affine_blocks, double of_element) {
  return {{tetrahedra, "tetrahedron", "tetrahedra", of_element},
          {affine_blocks, "affine block", "affine blocks", of_element}};
}

std::vector<Items> all_elements(const SceneSize& size, double of_element) {
  return elements(size.tetrahedra, size.affine_blocks, of_element);
}

std::vector<Items> bodies(const SceneSize& size, double of_element, double of_rigid) {
  std::vector<Items> items = all_elements(size, of_element);
  items.push_back({size.rigid_blocks, "rigid block", "rigid blocks", of_rigid});
  return items;
}

std::vector<Items> points(long count, double unit) {
  return {{count, "contact point at the start", "contact points at the start", unit}};
}

std::vector<Items> items_of(EffectKind kind, const Project& project, const SceneSize& size) {
  using namespace unit_cost;
  const bool corotational = project.solver.strain == Strain::corotational;
  const long all_points = size.loose_points + size.bonded_points;
  const long soft = size.neo_hookean_tetrahedra, soft_affine = size.neo_hookean_affine_blocks;
  switch (kind) {
    case EffectKind::elasticity:
      return elements(size.tetrahedra - soft, size.affine_blocks - soft_affine,
                      corotational ? corotational_element : incremental_element);
    case EffectKind::neo_hookean_elasticity:
      return elements(soft, soft_affine, neo_hookean_element);
    case EffectKind::initial_stress:
      return all_elements(size, corotational ? stress_in_situ_of_element : carried_stress_of_element);
    case EffectKind::inertia:
      return bodies(size, inertia_of_element, inertia_of_rigid);
    case EffectKind::body_force:
      return bodies(size, weight, weight);
    case EffectKind::damping:
      return bodies(size, damping_of_element, damping_of_rigid);
    case EffectKind::normal_contact:
      return points(size.loose_points, normal_point);
    case EffectKind::shear_contact:
      return points(size.sheared_points, shear_point);
    case EffectKind::rebound:
      return points(size.loose_points, rebound_point);
    case EffectKind::missed_contacts:
      return points(all_points, missed_contact_point);
    case EffectKind::updated_normals:
      return points(size.loose_points, updated_normal_point);
    case EffectKind::penalty_scaling:
      return points(size.loose_points, scaled_point);
    case EffectKind::followed_springs:
      return points(all_points, followed_point);
    case EffectKind::elimination:
      return points(all_points, eliminated_point);
    case EffectKind::restitution:  // in the law of impact, which pays for it
      return points(size.loose_points, 0);
    case EffectKind::acceleration_reset:
      return {{size.movable_blocks, "block", "blocks", reset_of_body}};
    case EffectKind::sleep:
      return {{size.movable_blocks, "block", "blocks", sleep_of_block}};
    case EffectKind::cohesion_and_tension:
      return {{size.bonded_points, "bonded point at the start", "bonded points at the start", bonded_point}};
    case EffectKind::displacement_constraint:
      return {{most_in_a_stage(project, held_points), "held point", "held points", held_point}};
    case EffectKind::point_load:
      break;
  }
  return {{most_in_a_stage(project, [](const Project& now) { return now.loads.size(); }), "load", "loads", load}};
}

}  // namespace

SceneSize scene_size(const Project& project, const BlockSystem& system) {
  SceneSize size;
  for (const Block& block : system.blocks) {
    const bool neo_hookean = project.materials[block.material].law == MaterialLaw::neo_hookean;
    const auto tetrahedra = static_cast<long>(block.mesh.tetrahedra.size());
    if (block.body == BodyKind::tetrahedra) size.tetrahedra += tetrahedra;
    if (block.body == BodyKind::tetrahedra && neo_hookean) size.neo_hookean_tetrahedra += tetrahedra;
    if (block.body == BodyKind::affine) ++size.affine_blocks;
    if (block.body == BodyKind::affine && neo_hookean) ++size.neo_hookean_affine_blocks;
    if (block.body == BodyKind::rigid) ++size.rigid_blocks;
    if (block.body != BodyKind::fixed) ++size.movable_blocks;
  }
  if (project.stages.empty()) return size;
  Simulation simulation(project, system);
  const ContactSet& contacts = simulation.look_for_contacts();
  size.loose_points = static_cast<long>(contacts.loose.size());
  size.bonded_points = static_cast<long>(contacts.bonded.size());
  size.sheared_points = static_cast<long>(contacts.sheared.size());
  return size;
}

std::vector<EffectCost> effect_costs(const Project& project, const BlockSystem& system, const SceneSize& size) {
  std::vector<EffectCost> costs;
  const std::size_t alone = blocks_alone_in_run(project, system, StepTolerances{});
  for (const EffectStatus& status : called_effects(project, system, alone)) {
    EffectCost& cost = costs.emplace_back(EffectCost{status.kind, status.active, status.reason, {}, 0});
    if (!status.active) continue;
    const std::vector<Items> all = items_of(status.kind, project, size);
    for (const Items& items : all) {
      cost.seconds += static_cast<double>(items.count) * items.unit;
      if (items.count == 0 && all.size() > 1) continue;
      if (!cost.items.empty()) cost.items += ", ";
      cost.items += counted_text(items.count, items.one, items.many);
    }
  }
  return costs;
}

}  // namespace talus
