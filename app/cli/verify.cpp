#include "study/verify.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "table.hpp"
#include "terminal.hpp"

namespace talus::cli {

namespace {

using Json = nlohmann::ordered_json;

struct VerifyOptions {
  std::vector<std::string> names;
  bool all = false;
  std::filesystem::path samples;
  int threads = 1;
};

/// Where samples lie: beside an installed program, else in the source tree it was built from.
std::filesystem::path samples_folder() {
  std::error_code unknown;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  const auto installed = program.parent_path().parent_path() / "share" / "talus" / "samples";
  return std::filesystem::is_directory(installed) ? installed : std::filesystem::path(TALUS_SAMPLES);
}

std::vector<Sample> chosen_samples(const VerifyOptions& options) {
  const auto folder = options.samples.empty() ? samples_folder() : options.samples;
  const auto samples = find_samples(folder);
  std::vector<Sample> chosen;
  for (const std::string& name : options.names) {
    const auto found = std::find_if(samples.begin(), samples.end(), [&](const Sample& s) { return s.name == name; });
    if (found == samples.end()) {
      std::string names;
      for (const Sample& sample : samples) names += (names.empty() ? "" : ", ") + sample.name;
      throw InputError(folder.string(), "holds no sample '" + name + "' with a known answer", "choose among " + names);
    }
    chosen.push_back(*found);
  }
  if (options.names.empty())
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(chosen),
                 [&](const Sample& sample) { return options.all || !sample.takes_long; });
  return chosen;
}

Json checks_of(const SampleOutcome& outcome) {
  Json checks = Json::array();
  for (const ExpectationOutcome& e : outcome.report.expect)
    checks.push_back({{"quantity", e.expectation.quantity},
                      {"time", e.expectation.time},
                      {"expected", e.expectation.value},
                      {"computed", e.reached ? Json(e.computed) : Json()},
                      {"error", e.reached ? Json(e.error) : Json()},
                      {"tolerance", e.expectation.tolerance},
                      {"passed", e.passed},
                      {"source", e.expectation.source}});
  const bool ordered = in_published_order(outcome.events);
  for (const EventComparison& c : outcome.events)
    checks.push_back({{"quantity", "time of: " + c.event.what},
                      {"time", c.computed ? Json(*c.computed) : Json()},
                      {"expected", c.event.time},
                      {"computed", c.computed ? Json(*c.computed) : Json()},
                      {"error", c.computed ? Json(*c.computed / c.event.time - 1) : Json()},
                      {"tolerance", "order"},
                      {"passed", ordered},
                      {"source", c.event.criterion}});
  return checks;
}

Json json_of(const SampleOutcome& outcome) {
  return {{"case", outcome.name},
          {"status", to_string(outcome.report.status)},
          {"reason", outcome.report.reason},
          {"seconds", outcome.seconds},
          {"passed", outcome.passed},
          {"checks", checks_of(outcome)}};
}

std::string text_of(const Json& value, int digits) {
  if (value.is_null()) return "–";
  return value.is_number() ? number(value, digits) : value.get<std::string>();
}

void print(const Json& cases) {
  Table table(
      {"Case", "Quantity", "Time [s]", "Expected", "Computed", "Error", "Tolerance", "Seconds", "Passed", "Source"},
      "llrrrrrrll");
  int failures = 0;
  for (const Json& one : cases) {
    const std::string name = one["case"], seconds = number(one["seconds"], 3);
    if (one["status"] != "completed")
      table.add({name, one["status"], "", "", "", "", "", seconds, "no", one["reason"]});
    for (const Json& check : one["checks"])
      table.add({name, check["quantity"], text_of(check["time"], 6), text_of(check["expected"], 8),
                 text_of(check["computed"], 8), text_of(check["error"], 2), text_of(check["tolerance"], 2), seconds,
                 check["passed"].get<bool>() ? "yes" : "no", check["source"]});
    failures += one["passed"].get<bool>() ? 0 : 1;
  }
  std::cout << table.text() << cases.size() - static_cast<std::size_t>(failures) << " of " << cases.size()
            << " cases passed\n";
}

ExitCode verify_all(const VerifyOptions& options, bool json) {
  catch_interrupts();
  Json cases = Json::array();
  bool passed = true;
  for (const Sample& sample : chosen_samples(options)) {
    TerminalProgress progress;
    const SampleOutcome outcome = about(sample.project, [&] { return verify(sample, options.threads, progress); });
    passed = passed && outcome.passed;
    cases.push_back(json_of(outcome));
  }
  if (json)
    std::cout << Json{{"passed", passed}, {"cases", cases}}.dump(2) << '\n';
  else
    print(cases);
  return passed ? done : failed;
}

}  // namespace

void add_verify(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("verify",
                                         "Run the shipped cases with a known answer: expected, computed, "
                                         "error, seconds");
  auto options = std::make_shared<VerifyOptions>();
  command->add_option("NAME", options->names, "Cases to run (default: all that are quick)")->type_name("");
  command->add_flag("--all", options->all,
                    "Also the long ones: more than " + std::to_string(quick_steps) + " time steps");
  command->add_option("--samples", options->samples, "Folder of the samples (default: the shipped ones)")
      ->type_name("DIR");
  add_threads(*command, options->threads);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return verify_all(*options, invocation.json); };
  });
}

}  // namespace talus::cli
