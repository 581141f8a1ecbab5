#include "verification/random_scenes_page.hpp"

#include "verification/markdown_table.hpp"
#include "verification/named_runs.hpp"
#include "verification/verify_random.hpp"

namespace talus {

namespace {

std::string what_fails(const std::vector<Trial>& trials) {
  std::string text;
  for (const Trial& trial : trials) {
    std::string words;
    for (const std::string& fault : faults(trial)) words += (words.empty() ? "" : "; ") + fault;
    if (!words.empty()) text += markdown_paragraph("- **" + trial.name + "** (" + trial.title + "): " + words, "  ");
  }
  return text.empty() ? text : "\n### What does not hold\n\n" + text;
}

}  // namespace

std::string random_scenes_page(const std::vector<Trial>& trials) {
  std::string text = passed_text("scenes", trials) + "\n\n";
  text += markdown_heading(
      {"Family", "What its scenes are and must come to", "Scenes", "Held", "What did not, in how many"}, "llrrl");
  for (const FamilyResult& result : family_results(trials))
    text += markdown_row({result.family, random_family(result.family).title, std::to_string(result.scenes),
                          std::to_string(result.held), faults_text(result)});
  return text + what_fails(trials);
}

}  // namespace talus
