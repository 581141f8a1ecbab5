#include "report/report.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "io/project_change.hpp"
#include "model/solid_shape.hpp"
#include "options.hpp"
#include "output_file.hpp"
#include "project_run.hpp"
#include "results/checkpoint.hpp"
#include "results/folder.hpp"
#include "results/summary.hpp"
#include "text/json_text.hpp"

namespace talus::cli {

namespace {

struct ReportOptions {
  ProjectChoice of;  ///< a project, or a results folder
  std::filesystem::path out, results;
  int threads = 1;
  bool anew = false;  ///< solves whatever results there are

  bool is_of_results() const { return !of.is_standard_input() && std::filesystem::is_directory(of.file); }
};

/// What a report is made of.
struct Solved {
  std::filesystem::path results;
  std::optional<RunReport> run{};  ///< none where it has not come to its end
  bool now = false;                ///< by this command
};

bool is_same_project(const std::filesystem::path& folder, const Project& project) {
  try {
    return read_project(folder / "project.talus", {.allow_outside = true}) == project;
  } catch (const InputError&) {  // of an older program, or gone
    return false;
  }
}

/// Whether a file of geometry that the project names was written after the run began.
bool has_newer_file(const std::filesystem::path& results, const Project& project, const std::filesystem::path& folder) {
  std::error_code gone;
  const auto began = std::filesystem::last_write_time(results / "project.talus", gone);
  return std::ranges::any_of(project.solids, [&](const Solid& solid) {
    const std::string* file = file_of(solid.shape);
    return file && std::filesystem::last_write_time(folder / *file, gone) > began;
  });
}

/// Why the results that are there cannot stand for the project; empty where they can.
std::string why_solved(const std::filesystem::path& results, const std::optional<RunReport>& run,
                       const Project& project, const std::filesystem::path& folder) {
  if (!std::filesystem::exists(results / "results.h5")) return "there are no results yet";
  if (!run || run->status == RunStatus::stopped) return "its run did not come to its end";
  if (!is_same_project(results, project)) return "the project is not that of the results that were there";
  if (has_newer_file(results, project, folder)) return "a file that the project names is newer than the results";
  return {};
}

/// Whether what the folder holds is the beginning of a run of the project.
bool may_go_on(const std::filesystem::path& results, const std::string& text) {
  try {
    const auto last = read_checkpoint_label(results / "checkpoint.h5");
    return last && !change_since_run(last->project_text, text);
  } catch (const InputError&) {  // damaged, or of a project that cannot be read any more
    return false;
  }
}

/// In the words of this command's options.
InputError with_own_options(const InputError& error) {
  std::string remedy = error.remedy();
  const auto say = [&remedy](const std::string& theirs, const std::string& ours) {
    if (const auto at = remedy.find(theirs); at != std::string::npos) remedy.replace(at, theirs.size(), ours);
  };
  say("choose another --out", "choose another --results");
  say("run the project without --resume", "solve it from the start by --anew");
  return InputError(error.place(), error.problem(), remedy);
}

/// The results of the project as it is: those that are there, or new ones.
Solved solved(const ReportOptions& options) {
  Solved found{results_folder(options.of, options.results, "--results")};
  const std::string text = text_of(options.of);
  const Project project = read(options.of, text);
  found.run = read_summary(found.results / "summary.json");
  const std::string why =
      options.anew ? "asked for" : why_solved(found.results, found.run, project, options.of.folder());
  if (why.empty()) {
    std::cerr << "Takes the results in " << found.results.string() << "; --anew solves the project again\n";
    return found;
  }
  std::cerr << "Solves the project into " << found.results.string() << ": " << why << '\n';
  const bool newer = has_newer_file(found.results, project, options.of.folder());
  const RunChoice choice{.out = found.results,
                         .threads = options.threads,
                         .resume = !options.anew && !newer && may_go_on(found.results, text)};
  try {
    if (std::filesystem::is_directory(found.results)) const FolderLock nobody_writes(found.results);
    found.run = solve_project(options.of, text, choice);
  } catch (const InputError& error) {
    throw with_own_options(error);
  }
  found.now = true;
  return found;
}

/// What is short of a run that was asked for, in one line; empty where nothing is.
std::string shortfall(const RunReport& run) {
  if (run.status != RunStatus::completed) return "the run is " + std::string(to_string(run.status)) + ": " + run.reason;
  if (const long missed = missed_expectations(run))
    return std::to_string(missed) + " of " + std::to_string(run.expect.size()) + " expectations are missed";
  return {};
}

void refuse_options_of_projects(const ReportOptions& options) {
  if (!options.results.empty() || options.anew)
    throw InputError(options.of.name(), "is a results folder, of which nothing is to be solved",
                     "leave --results and --anew out, or name the project");
}

ExitCode make_report(const ReportOptions& options, bool json) {
  const report::Writer write = report::writer_for(options.out);
  const bool of_results = options.is_of_results();
  if (of_results) refuse_options_of_projects(options);
  const Solved from = of_results ? Solved{options.of.file} : solved(options);
  if (from.now && from.run->status == RunStatus::stopped) {
    std::cerr << "talus-cli: stopped at t = " << from.run->time << " s, no report was written; the same command goes on"
              << '\n';
    return failed;
  }
  const report::Document document = about(from.results, [&] { return report::report_of(from.results); });
  write_output(options.out, write(document));
  if (json)
    std::cout << json_text({{"report", options.out.string()}, {"results", from.results.string()}, {"solved", from.now}})
              << '\n';
  else
    std::cout << options.out.string() << '\n';
  if (of_results || all_met(*from.run)) return done;
  std::cerr << "talus-cli: " << from.results.string() << ": " << shortfall(*from.run) << "; the report says where\n";
  return failed;
}

}  // namespace

void add_report(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("report",
                                         "Write all that a reader needs to believe a run, as HTML or PDF; solves a "
                                         "project that has no results yet");
  auto options = std::make_shared<ReportOptions>();
  add_project(*command, options->of, "PROJECT|RESULTS",
              "Results folder; or project file (.talus; - reads standard input), which is solved where its results are "
              "not there, not whole, or of another project");
  command->add_option("--out", options->out, "File to write; its ending says the format")
      ->required()
      ->type_name("R.html|R.pdf");
  command
      ->add_option("--results", options->results,
                   "Of a project: where its results are or go (default: NAME.results beside the project NAME.talus)")
      ->type_name("DIR");
  command->add_flag("--anew", options->anew, "Of a project: solve it from the start, whatever results there are");
  add_threads(*command, options->threads);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return make_report(*options, invocation.json); };
  });
}

}  // namespace talus::cli
