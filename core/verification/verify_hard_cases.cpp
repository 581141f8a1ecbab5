#include "verification/verify_hard_cases.hpp"

#include <algorithm>

#include "verification/named_runs.hpp"

namespace talus {

namespace {

void require_group(const std::vector<HardCase>& scenes, const std::string& group) {
  std::string known, last;
  for (const HardCase& scene : scenes) {
    if (scene.group == group) return;
    if (scene.group != last) (known += known.empty() ? "" : ", ") += scene.group;
    last = scene.group;
  }
  throw InputError("group '" + group + "'", "there is none of that name", "choose among " + known);
}

}  // namespace

std::vector<HardCase> chosen_hard_cases(const std::vector<HardCase>& scenes, const std::vector<std::string>& names,
                                        bool all, const std::string& group) {
  if (!group.empty()) require_group(scenes, group);
  std::vector<HardCase> chosen;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(scenes.begin(), scenes.end(), [&](const HardCase& scene) { return scene.name == name; });
    if (found == scenes.end()) throw none_of_that_name("scene", name, scenes);
    chosen.push_back(*found);
  }
  if (names.empty())
    std::copy_if(scenes.begin(), scenes.end(), std::back_inserter(chosen),
                 [&](const HardCase& scene) { return all || !scene.takes_long; });
  std::erase_if(chosen, [&](const HardCase& scene) { return !group.empty() && scene.group != group; });
  return chosen;
}

void verify_hard_cases(const std::vector<HardCase>& scenes, const TrialOptions& options, Progress& progress,
                       const std::function<void(const Trial&)>& ended) {
  run_in_turn(scenes, progress, [&](const HardCase& scene, Progress& part) { ended(run_trial(scene, options, part)); });
}

}  // namespace talus
