#include "model/rules/switched_effects.hpp"

#include <algorithm>
#include <string>

#include "model/joint_names.hpp"
#include "model/number_text.hpp"
#include "model/place.hpp"

namespace talus {

namespace {

using Kind = ProjectProblem::Kind;

class Look {
 public:
  explicit Look(const Project& project) : project_(project), solver_(project.solver), switches_(solver_.effects) {}

  std::vector<ProjectProblem> take() {
    look_at_contact();
    if (is_dynamic()) {
      look_at_impacts();
      look_at_depth();
      look_at_the_rest();
    }
    if (switches_.elimination == Switch::off)
      add(Kind::hint, "elimination", "a block that is far out of balance sets the pace of all",
          "leave it as it is called for: without, crowds take many more iterations");
    return std::move(problems_);
  }

 private:
  void add(Kind kind, const char* key, const std::string& problem, const std::string& remedy) {
    problems_.push_back({kind, (Place() / "solver" / "effects" / key).text(), problem, remedy});
  }
  bool is_dynamic() const {
    return std::any_of(project_.stages.begin(), project_.stages.end(),
                       [](const Stage& stage) { return stage.kind == StageKind::dynamic; });
  }

  void look_at_contact() {
    if (switches_.contact == Switch::off)
      add(Kind::warning, "contact", "contact is off: blocks pass through each other",
          "leave it as it is called for: blocks that cannot meet pay nothing for it");
    if (switches_.contact == Switch::on)
      add(Kind::hint, "contact", "contact is on for blocks too that can reach no other within the run",
          "leave it as it is called for: they then pay nothing for it");
  }

  void look_at_impacts() {
    const std::string given = joints_where(project_, [](const Joint& joint) { return joint.restitution.has_value(); });
    const bool none = solver_.extras == Extras::none && switches_.restitution != Switch::on;
    const bool no_law = switches_.rebound == Switch::off || (none && switches_.rebound == Switch::called_for);
    if (!given.empty() && no_law)
      add(Kind::warning, "rebound", "the restitution of " + given + " is given, and there is no law of impact",
          "switch it on, or leave the restitution out: springs decide at what speed blocks part");
    else if (switches_.rebound == Switch::off)
      add(Kind::warning, "rebound", "there is no law of impact: stiff springs may throw rigid blocks back",
          "leave it as it is called for, or give the joints a stiffness that steps can follow");
    if (!given.empty() && switches_.restitution == Switch::off)
      add(Kind::warning, "restitution", "the restitution of " + given + " is given, and switched off",
          "switch it on, or leave it out of the joint");
    if (given.empty() && switches_.restitution == Switch::on)
      add(Kind::hint, "restitution", "it is switched on, and no joint gives one", "give a joint its restitution");
  }

  void look_at_depth() {
    const std::string depth = solver_.penetration_tolerance
                                  ? "the penetration_tolerance of " + number_text(*solver_.penetration_tolerance)
                                  : "the usual penetration";
    if (switches_.penalty_scaling == Switch::off)
      add(Kind::warning, "penalty_scaling", depth + " is not held in dynamic stages",
          "leave it as it is called for, or see how deep blocks go in the results");
    if (switches_.updated_normals == Switch::off)
      add(Kind::warning, "updated_normals", depth + " is not held where blocks turn as they slide",
          "leave it as it is called for, or see how deep blocks go in the results");
    if (switches_.missed_contacts == Switch::off)
      add(Kind::warning, "missed_contacts", "edges that turn into a block within a step are found when they are deep",
          "leave it as it is called for, or take shorter steps");
  }

  void look_at_the_rest() {
    if (switches_.acceleration_reset == Switch::off)
      add(Kind::warning, "acceleration_reset", "a block that has landed goes on with the acceleration of the blow",
          "leave it as it is called for, or take an integrator that carries none on");
    if (switches_.followed_springs == Switch::off)
      add(Kind::hint, "followed_springs", "contacts that are too stiff for a step take many more iterations",
          "leave it as it is called for");
    if (switches_.sleep == Switch::off && solver_.lets_sleep())
      add(Kind::hint, "sleep", "blocks at rest cost as much as those that move", "leave it as it is called for");
    if (switches_.sleep == Switch::on && !solver_.lets_sleep())
      add(Kind::warning, "sleep", "it is switched on, and a sleep_tolerance of 0 lets no block sleep",
          "leave the sleep_tolerance out");
  }

  const Project& project_;
  const SolverSettings& solver_;
  const EffectSwitches& switches_;
  std::vector<ProjectProblem> problems_;
};

}  // namespace

std::vector<ProjectProblem> problems_of_switched_effects(const Project& project) { return Look(project).take(); }

}  // namespace talus
