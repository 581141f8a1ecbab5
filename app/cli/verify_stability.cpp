#include "verify_stability.hpp"

#include <iostream>

#include "list_of_runs.hpp"
#include "stability/all_scenes.hpp"
#include "study/verify_stability_json.hpp"
#include "trial_text.hpp"

namespace talus::cli {

ExitCode run_stability(const StabilityRequest& request, bool json) {
  std::vector<StabilityScene> scenes;
  for (const StabilityScene& one :
       chosen_scenes(stability_scenes(), request.names, request.all || request.list, request.group)) {
    const auto nudged = with_nudges(one, request.nudges);
    scenes.insert(scenes.end(), nudged.begin(), nudged.end());
  }
  if (request.list) {
    std::cout << (json ? list_json(scenes) : list_text(scenes));
    return done;
  }
  ListOfRuns<Trial> list;
  list.what = "scenes";
  list.count = scenes.size();
  list.run = [&](Progress& progress, const auto& ended) { verify_stability(scenes, request.options, progress, ended); };
  list.columns = trial_columns();
  list.text = trial_text;
  list.markdown = [](const std::vector<Trial>& trials) { return markdown_of(trials); };
  list.json = [](const std::vector<Trial>& trials, bool complete) { return json_text(trials, complete); };
  return run_list(list, request.markdown, json);
}

}  // namespace talus::cli
