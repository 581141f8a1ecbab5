#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

#include "base/error.hpp"
#include "studies/studies.hpp"
#include "study/accuracy/study_run.hpp"
#include "study/cases/case_run.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

/// A fraction, 0 … 1, a line on standard output: what the local engine reads.
class PlainProgress final : public Progress {
 public:
  void report(double fraction, std::string_view) override {
    constexpr double worth_telling = 0.005;
    if (fraction < told_ + worth_telling) return;
    told_ = fraction;
    std::printf("%.3f\n", fraction);
    std::fflush(stdout);
  }
  bool cancelled() const override { return interrupted(); }

 private:
  double told_ = -1;
};

template <typename Folder>
ExitCode perform(const Folder& study, int number, void (*run)(const Folder&, int, Progress&)) {
  if (number < 0 || number >= study.count())
    throw InputError("run " + std::to_string(number), "the study has runs 0 to " + std::to_string(study.count() - 1),
                     "choose one of these");
  PlainProgress progress;
  run(study, number, progress);
  return done;
}

ExitCode run_one(const std::filesystem::path& folder, int number) {
  catch_interrupts();
  return kind_of_study(folder) == "cases" ? perform(CaseFolder(folder), number, perform_case)
                                          : perform(StudyFolder(folder), number, perform_study_run);
}

/// What engines start; of no use by hand but to see why a run crashes.
void add_run(CLI::App& study, Invocation& invocation) {
  auto* command = study.add_subcommand("run", "Solve one run of a study and write its file")->group("");
  struct Choice {
    std::filesystem::path folder;
    int number = 0;
  };
  auto choice = std::make_shared<Choice>();
  command->add_option("DIR", choice->folder, "Folder of the study")->required()->type_name("DIR");
  command->add_option("N", choice->number, "Number of the run, from 0")->required()->type_name("N");
  command->callback(
      [&invocation, choice] { invocation.run = [choice] { return run_one(choice->folder, choice->number); }; });
}

}  // namespace

void add_study(CLI::App& program, Invocation& invocation) {
  auto* command =
      program.add_subcommand("study", "Solve many times: what accuracy costs, or many projects and parameters");
  command->require_subcommand(1);
  add_accuracy_study(*command, invocation);
  add_case_study(*command, invocation);
  add_run(*command, invocation);
  for (CLI::App* study : command->get_subcommands({})) study->fallthrough();
}

}  // namespace talus::cli
