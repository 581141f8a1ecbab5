#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "project_run.hpp"
#include "results/summary.hpp"
#include "text/json_text.hpp"
#include "text/report_text.hpp"

namespace talus::cli {

namespace {

struct SolveOptions {
  ProjectChoice project;
  RunChoice run;
};

ExitCode solve_and_tell(const SolveOptions& options, bool json) {
  RunChoice choice = options.run;
  choice.out = results_folder(options.project, choice.out, "--out");
  const RunReport report = solve_project(options.project, text_of(options.project), choice);
  if (json) {
    auto summary = nlohmann::ordered_json::parse(summary_json(report));
    summary["results"] = choice.out.string();
    std::cout << json_text(summary) << '\n';
  } else {
    std::cout << report_text(report) << "Results in " << choice.out.string() << '\n';
  }
  return all_met(report) ? done : failed;
}

}  // namespace

void add_solve(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("solve", "Cut, mesh and compute a project; Ctrl-C stops it after the step");
  auto options = std::make_shared<SolveOptions>();
  RunChoice& run = options->run;
  add_project(*command, options->project);
  command->add_option("--out", run.out, "Results folder (default: NAME.results beside the project NAME.talus)")
      ->type_name("DIR");
  command->add_flag("--resume", run.resume,
                    "Go on from the last checkpoint in the results folder, to the same numbers as an undisturbed run; "
                    "from the start where there is none");
  command
      ->add_option("--checkpoint-every", run.checkpoint_every,
                   "Seconds of computing between checkpoints; each stage has one before its end (60)")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--max-wall", run.max_wall,
                   "Seconds after which the run is stopped as by Ctrl-C, at the end of its step (default: none)")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e9));
  add_threads(*command, run.threads);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return solve_and_tell(*options, invocation.json); };
  });
}

}  // namespace talus::cli
