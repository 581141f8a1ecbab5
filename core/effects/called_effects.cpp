#include "effects/called_effects.hpp"

#include <algorithm>

#include "bodies/body_set.hpp"
#include "bodies/time_integration.hpp"
#include "model/joint_names.hpp"
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

/// All stages' projects in one: an effect is on if any stage calls for it.
template <class Calls>
bool in_any_stage(const Project& project, Calls calls) {
  for (int stage = 0; stage < static_cast<int>(project.stages.size()); ++stage)
    if (calls(project_in_stage(project, stage))) return true;
  return calls(project);
}

bool damps(const Project& project) {
  return std::any_of(project.materials.begin(), project.materials.end(),
                     [](const Material& m) { return m.damping > 0; }) ||
         std::any_of(project.stages.begin(), project.stages.end(),
                     [](const Stage& s) { return s.damping.value_or(0) > 0; });
}

/// What a project makes of an effect that the scene calls for, or does not.
class Calls {
 public:
  explicit Calls(const Project& project) : project_(project) {}

  void add(EffectKind kind, bool active, const std::string& on, const std::string& off) {
    list_.push_back({kind, active, active ? on : off});
  }
  /// What the project may force on or off, where it is `possible` at all.
  void add(EffectKind kind, Switch choice, bool possible, const std::string& impossible, bool called,
           const std::string& on, const std::string& off) {
    if (choice == Switch::off)
      add(kind, false, "", "the project switches it off");
    else if (!possible)
      add(kind, false, "", impossible);
    else if (choice == Switch::on)
      add(kind, true, "the project switches it on", "");
    else if (project_.solver.extras == Extras::none && kind != EffectKind::elimination)
      add(kind, false, "", "the settings ask for nothing beyond the equations");
    else
      add(kind, called, on, off);
  }
  bool last_is_active() const { return list_.back().active; }
  std::vector<EffectStatus> take() { return std::move(list_); }

 private:
  const Project& project_;
  std::vector<EffectStatus> list_;
};

bool is_any_stage(const Project& project, StageKind kind) {
  return std::any_of(project.stages.begin(), project.stages.end(), [=](const Stage& s) { return s.kind == kind; });
}

/// Joints as the project has them, and as each stage does.
std::vector<Joint> joints_of_all_stages(const Project& project) {
  std::vector<Joint> joints = project.joints;
  for (int stage = 0; stage < static_cast<int>(project.stages.size()); ++stage) {
    const std::vector<Joint> now = project_in_stage(project, stage).joints;
    joints.insert(joints.end(), now.begin(), now.end());
  }
  return joints;
}

/// Blocks by what they may do, and what contact there is.
struct Scene {
  Scene(const Project& project, const BlockSystem& system, std::size_t blocks_alone)
      : blocks(system.blocks.size()),
        movable(static_cast<std::size_t>(std::count_if(system.blocks.begin(), system.blocks.end(),
                                                       [](const Block& b) { return b.body != BodyKind::fixed; }))),
        linear(deforming_blocks(project, system, MaterialLaw::linear)),
        neo_hookean(deforming_blocks(project, system, MaterialLaw::neo_hookean)),
        rigid(movable - linear - neo_hookean),
        affine(static_cast<std::size_t>(std::count_if(system.blocks.begin(), system.blocks.end(),
                                                      [](const Block& b) { return b.body == BodyKind::affine; }))),
        alone(project.solver.effects.contact == Switch::on ? 0 : std::min(blocks_alone, movable)),
        touching(project.solver.effects.contact != Switch::off && movable > alone && blocks > 1),
        dynamic(is_any_stage(project, StageKind::dynamic)),
        joints(joints_of_all_stages(project)) {
    if (project.solver.effects.contact == Switch::off)
      no_touch = "the project switches contact off";
    else
      no_touch = alone > 0 && blocks > 1 ? "no block can reach another within the run" : "nothing can touch";
    no_motion = touching ? "every stage is static" : no_touch;
  }
  bool any_joint(bool (*has)(const Joint&)) const { return std::any_of(joints.begin(), joints.end(), has); }
  std::string who_touches() const {
    const std::string can = count(blocks - alone, "block", "blocks") + " can touch";
    return alone == 0 ? can : can + "; " + count(alone, "reaches", "reach") + " no other within the run";
  }

  std::size_t blocks, movable, linear, neo_hookean, rigid, affine, alone;
  bool touching, dynamic;
  std::vector<Joint> joints;        ///< of all stages
  std::string no_touch, no_motion;  ///< why nothing touches; why nothing does in a dynamic stage
};

void add_contact(const Project& project, const Scene& scene, Calls& calls) {
  const auto resists = [](const Joint& j) { return j.friction_angle > 0 || j.cohesion > 0; };
  const auto bonds = [](const Joint& j) { return j.cohesion > 0 || j.tensile_strength > 0; };
  const auto off = [&](const std::string& otherwise) { return scene.touching ? otherwise : scene.no_touch; };
  calls.add(EffectKind::normal_contact, scene.touching, scene.who_touches(), scene.no_touch);
  calls.add(EffectKind::shear_contact, scene.touching && scene.any_joint(resists),
            "friction or cohesion on " + joints_where(project, resists), off("no joint resists shear"));
  calls.add(EffectKind::cohesion_and_tension, scene.touching && scene.any_joint(bonds),
            "bonds on " + joints_where(project, bonds), off("no joint has cohesion or tensile strength"));
}

bool gives_restitution(const Joint& joint) { return joint.restitution.has_value(); }

void add_rebound(const Project& project, const Scene& scene, Calls& calls) {
  const EffectSwitches& switches = project.solver.effects;
  const bool given = switches.restitution != Switch::off && scene.any_joint(gives_restitution);
  const Switch choice = given && switches.restitution == Switch::on && switches.rebound == Switch::called_for
                            ? Switch::on
                            : switches.rebound;
  calls.add(EffectKind::rebound, choice, scene.touching && scene.dynamic, scene.no_motion, true,
            given ? "restitution of " + joints_where(project, gives_restitution)
                  : "a contact too stiff for the step throws no block back",
            "");
}

/// What is no term of the potential, and no law of impact.
void add_the_rest(const Project& project, const Scene& scene, bool rebounds, Calls& calls) {
  const SolverSettings& solver = project.solver;
  const EffectSwitches& switches = solver.effects;
  const bool touches = scene.touching && scene.dynamic;
  const auto own_stiffness = [](const Joint& j) { return j.normal_stiffness.has_value(); };
  const auto lacks_stiffness = [](const Joint& j) { return !j.normal_stiffness.has_value(); };
  const bool scaled = project.joints.empty() || scene.any_joint(lacks_stiffness);
  const bool newton = solver.open_close == OpenCloseMethod::newton;
  calls.add(EffectKind::restitution, switches.restitution, rebounds && scene.any_joint(gives_restitution),
            rebounds ? "no joint gives one" : "there is no law of impact", true,
            "of " + joints_where(project, gives_restitution), "");
  calls.add(EffectKind::missed_contacts, switches.missed_contacts, touches && solver.contact == ContactModel::area,
            touches ? "facet-wise contact looks for none" : scene.no_motion, true,
            "blocks may turn into each other within a step", "");
  calls.add(EffectKind::updated_normals, switches.updated_normals, touches, scene.no_motion, true,
            "contacts may turn within a step", "");
  const std::string given = "all stiffness is given: " + joints_where(project, own_stiffness);
  const bool multiplied = solver.penetration_tolerance && !scene.dynamic;
  calls.add(EffectKind::penalty_scaling, switches.penalty_scaling,
            scene.touching && !multiplied && (scaled || solver.penetration_tolerance),
            !scene.touching ? scene.no_touch
            : multiplied    ? "multipliers keep to the penetration_tolerance: every stage is static"
                            : given,
            true, "a penetration is to be kept to", "");
  calls.add(EffectKind::followed_springs, switches.followed_springs, scene.touching && scaled,
            !scene.touching ? scene.no_touch : given, true, "contacts may be too stiff for a step", "");
  const bool moves = scene.movable > 0 && scene.dynamic;
  const std::string nothing_moves = scene.movable == 0 ? "every block is fixed" : "every stage is static";
  const bool carried = TimeIntegration::of(solver).carries_acceleration();
  calls.add(EffectKind::acceleration_reset, switches.acceleration_reset, moves && carried,
            moves ? "the integrator carries no acceleration on" : nothing_moves, true,
            "the integrator carries accelerations on", "");
  calls.add(EffectKind::sleep, switches.sleep, moves && solver.lets_sleep(),
            moves ? "a sleep tolerance of 0 lets no block sleep" : nothing_moves, true, "blocks may come to rest", "");
  calls.add(EffectKind::elimination, switches.elimination, scene.touching && newton && scene.movable > 1,
            !scene.touching ? scene.no_touch
            : !newton       ? "contacts keep their states for a round"
                            : "one block moves alone",
            true, "a few blocks may be far out of balance while the others are not", "");
}

}  // namespace

bool holds_points(const Project& project) {
  return std::any_of(project.constraints.begin(), project.constraints.end(),
                     [](const Constraint& c) { return c.at.has_value(); });
}

std::vector<EffectStatus> called_effects(const Project& project, const BlockSystem& system, std::size_t alone) {
  const Scene scene(project, system, alone);
  const std::size_t deformable = scene.linear + scene.neo_hookean;
  const bool corotational = project.solver.strain == Strain::corotational;
  Calls calls(project);
  const std::string frame = corotational ? ", measured in the rotated frame" : ", summed up step by step";
  const std::string still = "every block is fixed";
  const std::string stiff = scene.movable == 0 ? still : "every block that moves is rigid";
  calls.add(EffectKind::elasticity, scene.linear > 0, count(scene.linear, "block deforms", "blocks deform") + frame,
            deformable == 0 ? stiff : "every block that deforms is neo-Hookean");
  calls.add(EffectKind::neo_hookean_elasticity, scene.neo_hookean > 0,
            count(scene.neo_hookean, "block deforms", "blocks deform") + " by that law",
            "no material that deforms asks for it");
  calls.add(EffectKind::initial_stress, deformable > 0 && (!corotational || !project.in_situ.empty()),
            corotational ? "stress in situ" : "stress is carried from step to step",
            deformable == 0 ? stiff : "no stress in situ; corotational strain carries none from step to step");
  calls.add(EffectKind::inertia, scene.movable > 0,
            is_any_stage(project, StageKind::static_) ? "always; static stages start every step at rest"
                                                      : "always; the velocity is carried on",
            still);
  calls.add(EffectKind::displacement_constraint, in_any_stage(project, holds_points), "points are held",
            "no point is held");
  calls.add(EffectKind::point_load, in_any_stage(project, [](const Project& p) { return !p.loads.empty(); }),
            "forces on points", "no point load");
  calls.add(EffectKind::body_force, scene.movable > 0 && project.gravity.norm() > 0, "gravity", "no gravity");
  add_contact(project, scene, calls);
  add_rebound(project, scene, calls);
  const bool rebounds = calls.last_is_active();
  calls.add(EffectKind::damping, scene.movable > 0 && damps(project), "a stage or a material asks for it",
            "no stage or material asks for it");
  add_the_rest(project, scene, rebounds, calls);
  return calls.take();
}

}  // namespace talus
