#include "verification/hard_cases_page.hpp"

#include "model/number_text.hpp"
#include "verification/markdown_table.hpp"
#include "verification/named_runs.hpp"

namespace talus {

namespace {

std::string expected_text(const Trial& trial) {
  std::string text;
  for (const std::string& words : trial.expected) (text += text.empty() ? "" : "; ") += words;
  return text;
}

std::string group_text(const std::string& group, const std::vector<Trial>& trials) {
  std::string text = "### " + group + "\n\n" +
                     markdown_heading({"Scene", "What", "Must come to", "Ending", "Penetration", "Growth", "Iterations",
                                       "at most", "Cuts", "Holds"},
                                      "llllrrrrrl");
  for (const Trial& trial : trials)
    if (trial.group == group) text += trial_row(trial);
  return text + '\n';
}

std::string in_brackets(const std::string& words) { return words.empty() ? "" : " (" + words + ')'; }

std::string faults_text(const std::vector<Trial>& trials) {
  std::string text;
  for (const Trial& trial : trials)
    for (const std::string& fault : faults(trial))
      text += markdown_paragraph("- **" + trial.name + "**: " + fault + in_brackets(trial.known_shortfall), "  ");
  return text.empty() ? text : "### What does not hold\n\n" + text + '\n';
}

}  // namespace

std::string trial_row(const Trial& trial) {
  return markdown_row({trial.name, trial.title + in_brackets(trial.source), expected_text(trial),
                       std::string(to_string(trial.ending)), significant(trial.penetration, 2),
                       significant(trial.energy_growth, 2), significant(trial.iterations_per_step(), 3),
                       std::to_string(trial.most_iterations), std::to_string(trial.cuts),
                       trial.passed() ? "yes" : "NO"});
}

std::string hard_cases_page(const std::vector<Trial>& trials) {
  std::string text = passed_text("scenes", trials) + "\n\n", group;
  for (const Trial& trial : trials) {
    if (trial.group == group) continue;
    group = trial.group;
    text += group_text(group, trials);
  }
  return text + faults_text(trials);
}

}  // namespace talus
