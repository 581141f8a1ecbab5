#include "verify_hard_cases.hpp"

#include <iostream>

#include "list_of_runs.hpp"
#include "text/trial_text.hpp"
#include "verification/hard_cases/scenes/all_hard_cases.hpp"
#include "verification/hard_cases_page.hpp"
#include "verification/verify_hard_cases_json.hpp"

namespace talus::cli {

ExitCode run_hard_cases(const HardCasesRequest& request, bool json) {
  std::vector<HardCase> scenes;
  for (const HardCase& one :
       chosen_hard_cases(hard_cases(), request.names, request.all || request.list, request.group)) {
    const auto perturbed = with_perturbations(one, request.perturbations);
    scenes.insert(scenes.end(), perturbed.begin(), perturbed.end());
  }
  if (request.list) {
    std::cout << (json ? list_json(scenes) : list_text(scenes));
    return done;
  }
  ListOfRuns<Trial> list;
  list.what = "scenes";
  list.count = scenes.size();
  list.run = [&](Progress& progress, const auto& ended) {
    verify_hard_cases(scenes, request.options, progress, ended);
  };
  list.columns = trial_columns();
  list.text = trial_text;
  list.markdown = hard_cases_page;
  list.json = [](const std::vector<Trial>& trials, bool complete) { return json_text(trials, complete); };
  return run_list(list, request.markdown, json);
}

}  // namespace talus::cli
