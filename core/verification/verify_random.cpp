#include "verification/verify_random.hpp"

#include <algorithm>
#include <set>

#include "verification/named_runs.hpp"

namespace talus {

namespace {

/// As lists of runs want them.
struct NamedScene {
  RandomSceneName scene;
  std::string name;
};

}  // namespace

std::vector<RandomSceneName> random_scene_names(const RandomChoice& choice) {
  std::vector<std::string> families;
  for (const std::string& family : choice.families) families.emplace_back(random_family(family).name);
  if (families.empty())
    for (const RandomFamily& family : random_families()) families.emplace_back(family.name);
  std::vector<RandomSceneName> names;
  for (int i = 0; i < choice.count; ++i) {
    const auto turn = static_cast<std::size_t>(i);
    names.push_back({families[turn % families.size()], choice.seed, turn / families.size() + 1, choice.bodies,
                     choice.other_settings});
  }
  return names;
}

void verify_random(const std::vector<RandomSceneName>& names, const TrialOptions& options, Progress& progress,
                   const std::function<void(const HardCase&, const Trial&)>& ended) {
  std::vector<NamedScene> scenes;
  for (const RandomSceneName& name : names) scenes.push_back({name, to_string(name)});
  run_in_turn(scenes, progress, [&](const NamedScene& named, Progress& part) {
    const HardCase scene = random_scene(named.scene);
    ended(scene, run_trial(scene, options, part));
  });
}

std::vector<FamilyResult> family_results(const std::vector<Trial>& trials) {
  std::vector<FamilyResult> results;
  for (const Trial& trial : trials) {
    auto result = std::find_if(results.begin(), results.end(),
                               [&](const FamilyResult& one) { return one.family == trial.group; });
    if (result == results.end()) result = results.insert(results.end(), FamilyResult{.family = trial.group});
    std::set<FaultKind> kinds;
    for (const Fault& fault : faults_by_kind(trial)) kinds.insert(fault.kind);
    for (const FaultKind kind : kinds) ++result->faults[kind];
    ++result->scenes;
    result->held += kinds.empty() ? 1 : 0;
    result->seconds += trial.seconds;
  }
  return results;
}

std::string faults_text(const FamilyResult& result) {
  std::string text;
  for (const auto& [kind, count] : result.faults)
    text += (text.empty() ? "" : ", ") + std::string(to_string(kind)) + ' ' + std::to_string(count);
  return text;
}

}  // namespace talus
