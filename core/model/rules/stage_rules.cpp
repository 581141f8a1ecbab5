#include "model/rules/stage_rules.hpp"

#include <algorithm>
#include <set>

#include "model/number_text.hpp"
#include "model/require.hpp"
#include "model/rules/joint_rules.hpp"
#include "model/stage_changes.hpp"

namespace talus {
namespace {

void check_length(const Stage& stage, const Place& place) {
  require_positive(stage.time_step, place / "time_step", "the time step", "seconds");
  require(stage.steps.has_value() != stage.duration.has_value(), place,
          stage.steps ? "has both steps and duration" : "has neither steps nor duration",
          "give one of them: the number of steps, or the duration in seconds");
  if (stage.steps) {
    require(*stage.steps >= 1, place / "steps", "steps must be at least 1, is " + std::to_string(*stage.steps),
            "give the number of time steps");
  }
  if (!stage.duration) return;
  require_positive(*stage.duration, place / "duration", "the duration", "seconds");
  require(*stage.duration >= stage.time_step, place / "duration",
          "the stage is shorter than one time step of " + number_text(stage.time_step) + " s",
          "lengthen the duration or shorten the time_step");
  constexpr double most_steps = 2147483647;  // as many as steps may be
  require(*stage.duration / stage.time_step <= most_steps, place / "duration",
          "the stage takes more than 2147483647 steps", "shorten the duration or lengthen the time_step");
}

void check_equilibrium(const Stage& stage, const Place& place) {
  require(!stage.until_equilibrium || stage.kind == StageKind::static_, place / "until_equilibrium",
          "a dynamic stage does not end at equilibrium",
          "make the stage static, or leave 'until_equilibrium' out and give its duration");
  require_positive(stage.equilibrium_tolerance, place / "equilibrium_tolerance", "the equilibrium tolerance",
                   "unbalanced force over the largest force; 1e-5 is usual");
  require(stage.until_equilibrium || stage.equilibrium_tolerance == Stage{}.equilibrium_tolerance,
          place / "equilibrium_tolerance", "the stage does not ask for equilibrium",
          "add \"until_equilibrium\": true to a static stage, or leave the tolerance out");
}

template <typename Things>
void check_given_once(const Things& things, const auto& place_of) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < things.size(); ++i) {
    require(names.insert(things[i].name).second, place_of(i), "'" + things[i].name + "' is changed twice in this stage",
            "keep one of the two changes");
  }
}

/// `after` are the joints as they are from this stage on.
void check_joint_changes(const Stage& stage, const std::vector<Joint>& after, const Place& place) {
  check_given_once(stage.joints, [&](std::size_t i) { return place / stage.joints[i].name; });
  for (const JointChange& change : stage.joints) {
    const bool changes =
        change.friction_angle || change.residual_friction_angle || change.cohesion || change.tensile_strength;
    require(changes, place / change.name, "changes nothing",
            "give friction_angle, residual_friction_angle, cohesion or tensile_strength, or remove it");
    const auto joint = std::find_if(after.begin(), after.end(), [&](const Joint& j) { return j.name == change.name; });
    if (joint != after.end()) check(*joint, place / change.name);
  }
}

}  // namespace

void check_stages(const Project& project) {
  for (std::size_t i = 0; i < project.stages.size(); ++i) {
    const Stage& stage = project.stages[i];
    const Place place = Place() / "stages" / i;
    check_length(stage, place);
    check_equilibrium(stage, place);
    if (stage.damping) require_not_negative(*stage.damping, place / "damping", "damping", "1/s");
    check_joint_changes(stage, project_in_stage(project, static_cast<int>(i)).joints, place / "joints");
    check_given_once(stage.blocks, [&](std::size_t k) { return place / "blocks" / k / "name"; });
  }
}

}  // namespace talus
