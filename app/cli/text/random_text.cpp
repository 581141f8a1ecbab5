#include "text/random_text.hpp"

#include "text/paragraph.hpp"
#include "text/table.hpp"
#include "text/trial_text.hpp"
#include "verification/verify_random.hpp"

namespace talus::cli {

std::string random_trial_text(const Trial& trial) { return trial_text(trial) + paragraph(trial.title, 4); }

std::string families_text(const std::vector<Trial>& trials) {
  Table table({"Family", "Scenes", "Held", "Seconds", "What did not, in how many"}, "lrrrl");
  for (const FamilyResult& result : family_results(trials))
    table.add({result.family, std::to_string(result.scenes), std::to_string(result.held), number(result.seconds, 3),
               faults_text(result)});
  return table.text();
}

std::string family_list_text() {
  Table table({"Family", "What its scenes are and must come to"}, "ll");
  for (const RandomFamily& family : random_families()) table.add({family.name, family.title});
  return table.text();
}

}  // namespace talus::cli
