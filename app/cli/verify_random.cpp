#include "verify_random.hpp"

#include <charconv>
#include <chrono>
#include <iostream>

#include "base/error.hpp"
#include "list_of_runs.hpp"
#include "text/random_text.hpp"
#include "text/trial_text.hpp"
#include "verification/failed_scene.hpp"
#include "verification/random_scenes_page.hpp"
#include "verification/verify_random_json.hpp"

namespace talus::cli {

namespace {

std::uint64_t seed_from(const std::string& text) {
  if (text == "now")
    return static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch() /
                                      std::chrono::milliseconds(1));
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  if (const auto read = std::from_chars(text.data(), end, seed); read.ec != std::errc() || read.ptr != end)
    throw InputError("--seed '" + text + "'", "it is no seed", "write a whole number, or now");
  return seed;
}

std::vector<RandomSceneName> asked_scenes(const RandomRequest& request) {
  std::vector<RandomSceneName> names;
  for (const std::string& scene : request.scenes) names.push_back(random_scene_name_from(scene));
  if (request.count == 0) return names;
  RandomChoice choice{request.count, seed_from(request.seed), request.families, {}, request.other_settings};
  if (!request.bodies.empty()) choice.bodies = random_bodies_from(request.bodies);
  const std::vector<RandomSceneName> drawn = random_scene_names(choice);
  names.insert(names.end(), drawn.begin(), drawn.end());
  if (request.seed == "now") std::cerr << "talus-cli: seed " << choice.seed << '\n';
  return names;
}

}  // namespace

ExitCode run_random(const RandomRequest& request, bool json) {
  if (request.list) {
    std::cout << (json ? family_list_json() : family_list_text());
    return done;
  }
  const std::vector<RandomSceneName> names = asked_scenes(request);
  ListOfRuns<Trial> list;
  list.what = "scenes";
  list.count = names.size();
  list.run = [&](Progress& progress, const auto& ended) {
    verify_random(names, request.options, progress, [&](const HardCase& scene, const Trial& trial) {
      if (!request.folder.empty() && !trial.passed())
        write_failed_scene(request.folder, scene, trial, request.options, progress);
      ended(trial);
    });
  };
  list.columns = trial_columns();
  list.text = [&](const Trial& trial) {
    return trial.passed() && request.scenes.empty() ? std::string() : random_trial_text(trial);
  };
  list.summary = families_text;
  list.markdown = random_scenes_page;
  list.json = [](const std::vector<Trial>& trials, bool complete) { return random_json_text(trials, complete); };
  return run_list(list, request.markdown, json);
}

}  // namespace talus::cli
