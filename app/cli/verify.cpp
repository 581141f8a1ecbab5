#include "study/verify.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>

#include "command.hpp"
#include "options.hpp"
#include "study/verify_json.hpp"
#include "terminal.hpp"
#include "verify_markdown.hpp"
#include "verify_text.hpp"

namespace talus::cli {

namespace {

struct Request {
  std::vector<std::string> names;
  bool all = false, list = false, tables = false;
  std::filesystem::path samples, markdown;
  VerifyOptions options;
};

/// Where samples lie: beside an installed program, else in the source tree it was built from.
std::filesystem::path samples_folder() {
  std::error_code unknown;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  const auto installed = program.parent_path().parent_path() / "share" / "talus" / "samples";
  return std::filesystem::is_directory(installed) ? installed : std::filesystem::path(TALUS_SAMPLES);
}

/// Runs the cases and prints each as it ends, unless it is to be JSON; false when it was stopped before the last.
bool run_cases(const std::vector<KnownCase>& cases, const Request& request, bool json,
               std::vector<CaseResult>& results) {
  TerminalProgress progress;
  try {
    verify(cases, request.options, progress, [&](const CaseResult& result) {
      progress.clear_bar();
      if (!json) std::cout << case_text(result, request.tables) << std::flush;
      results.push_back(result);
    });
  } catch (const Cancelled&) {
    return false;
  }
  return true;
}

ExitCode verify_cases(const Request& request, bool json) {
  const auto known = all_cases(request.samples.empty() ? samples_folder() : request.samples);
  const auto cases = chosen_cases(known, request.names, request.all || request.list, request.options.run.body);
  if (request.list) {
    std::cout << (json ? list_json(cases) : list_text(cases));
    return done;
  }
  if (!request.markdown.empty()) check_markdown(request.markdown);

  catch_interrupts();
  if (!json) std::cout << case_columns() << std::flush;
  std::vector<CaseResult> results;
  const bool complete = run_cases(cases, request, json, results);
  std::cout << (json ? json_text(results, complete) : verdict_text(results));
  if (!complete) std::cerr << "talus-cli: stopped; " << cases.size() - results.size() << " cases were not run\n";
  if (complete && !request.markdown.empty()) write_markdown(request.markdown, results);
  const bool passed = std::all_of(results.begin(), results.end(), [](const CaseResult& r) { return r.passed(); });
  return complete && passed ? done : failed;
}

void add_run_options(CLI::App& command, VerifyOptions& options) {
  command
      .add_option("--scale", options.run.scale,
                  "Run at another scale: of all lengths; times go with its root, stresses with itself")
      ->check(CLI::Validator(CLI::PositiveNumber).description(""))
      ->type_name("S")
      ->capture_default_str();
  add_threads(command, options.run.threads);
  static const std::map<std::string, BodyKind> bodies{
      {"tetrahedra", BodyKind::tetrahedra}, {"affine", BodyKind::affine}, {"rigid", BodyKind::rigid}};
  command
      .add_option_function<std::string>(
          "--body", [&options](const std::string& word) { options.run.body = bodies.at(word); },
          "Run with blocks of this kind where tetrahedra stand otherwise (those cases that ask for no strain)")
      ->check(CLI::IsMember(bodies).description(""))
      ->type_name("rigid|affine|tetrahedra")
      ->default_str("tetrahedra");
  command.add_flag("--repeat", options.repeat,
                   "Run each case again with 2 threads, which must give the same bits, and at a tenth of the scale, "
                   "which must give the same relative numbers");
}

}  // namespace

void add_verify(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand(
      "verify",
      "Run the cases with a known answer: expected, computed, error, tolerance, seconds and source.\n"
      "Error and tolerance are relative to the expected number; with ± they are in its unit");
  auto request = std::make_shared<Request>();
  command->add_option("NAME", request->names, "Cases to run (default: all that are quick)")->type_name("");
  command->add_flag("--all", request->all, "Also those that take minutes, and every row of those that are thinned");
  command->add_flag("--list", request->list, "List the cases there are and leave");
  add_run_options(*command, request->options);
  command->add_flag("--tables", request->tables, "Print the tables of cases that have more than numbers");
  command
      ->add_option("--markdown", request->markdown,
                   "Write the results into this page, between its lines <!-- talus-cli verify: begin --> and "
                   "<!-- talus-cli verify: end -->")
      ->type_name("FILE");
  command->add_option("--samples", request->samples, "Folder of the samples (default: the shipped ones)")
      ->type_name("DIR");
  command->callback([&invocation, request] {
    request->options.run.thorough = request->all;
    invocation.run = [&invocation, request] { return verify_cases(*request, invocation.json); };
  });
}

}  // namespace talus::cli
