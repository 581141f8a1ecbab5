#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

#include "base/error.hpp"
#include "studies/engine_choice.hpp"
#include "studies/studies.hpp"
#include "study/cases/case_study.hpp"
#include "text/cases_text.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

struct CasesOptions {
  CaseRequest request;
  std::filesystem::path out;
  EngineChoice engine;
  bool drop_results = false;
};

/// NAME.cases beside the project or folder NAME.
std::filesystem::path study_folder(const CasesOptions& options) {
  if (!options.out.empty()) return options.out;
  if (options.request.projects.size() > 1)
    throw InputError("--out", "several projects have no name that a folder could have", "give one with --out");
  const auto whole = std::filesystem::absolute(options.request.projects.front()).lexically_normal();
  const auto named = whole.has_filename() ? whole : whole.parent_path();  // without the stroke behind a folder
  return std::filesystem::path(named).replace_extension(".cases");
}

CaseFolder open_study(const CasesOptions& options) {
  for (const auto& project : options.request.projects)
    if (project == "-")
      throw InputError("-", "a study goes on by the names of its projects", "write the project into a file");
  CaseRequest request = options.request;
  request.program = TALUS_VERSION;
  request.keep_results = !options.drop_results;
  return CaseFolder(study_folder(options), make_case_plan(request), options.engine.restart);
}

/// Done where every case completed.
ExitCode cases(const CasesOptions& options, bool json) {
  catch_interrupts();
  const CaseFolder folder = open_study(options);
  const bool all_made = make_runs(folder, options.engine);
  const CaseStudy study = evaluate_cases(folder);
  write_case_files(study, folder);
  if (!all_made) return failed;
  if (json)
    std::cout << cases_json(study);
  else
    std::cout << cases_text(study) << "Study in " << folder.path().string() << '\n';
  return tell_missing(folder) && study.with_status("completed") == folder.count() ? done : failed;
}

}  // namespace

void add_case_study(CLI::App& study, Invocation& invocation) {
  auto* command = study.add_subcommand(
      "cases",
      "Solve several projects, or one under the values of a table, each case a run; tell in one table what they came\n"
      "to. A study that was stopped goes on where it was, each case from its checkpoint.");
  auto options = std::make_shared<CasesOptions>();
  command->add_option("PROJECT", options->request.projects, "Project files (.talus), or folders with projects")
      ->required()
      ->type_name("PATH");
  command
      ->add_option("--table", options->request.table,
                   "CSV with a line a case; columns are headed by places of the one project, like "
                   "/joints/J1/friction_angle or /cuts/0/dip, and by case for their names")
      ->type_name("CSV");
  command->add_option("--out", options->out, "Folder of the study (default: NAME.cases beside the project or folder)")
      ->type_name("DIR");
  command->add_flag("--allow-outside", options->request.allow_outside,
                    "Let projects name files outside their own folders");
  command->add_flag("--drop-results", options->drop_results,
                    "Keep the table alone: the results of a case go once it has been measured");
  add_engine(*command, options->engine);
  command->callback(
      [&invocation, options] { invocation.run = [&invocation, options] { return cases(*options, invocation.json); }; });
}

}  // namespace talus::cli
