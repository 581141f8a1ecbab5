#include "verification/verify.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>

#include "base/installed.hpp"
#include "list_of_runs.hpp"
#include "model/tolerance_text.hpp"
#include "options.hpp"
#include "text/verify_text.hpp"
#include "verification/known_answers_page.hpp"
#include "verification/verify_json.hpp"
#include "verify_hard_cases.hpp"
#include "verify_random.hpp"

namespace talus::cli {

namespace {

struct Request {
  std::vector<std::string> names;
  bool all = false, list = false, tables = false;
  bool hard_cases = false;
  int perturbations = 0;
  bool elsewhere = false;
  std::string group;
  std::string body;
  RandomRequest random;
  std::filesystem::path samples, markdown;
  VerifyOptions options;
};

/// That of known cases. Throws InputError for a word that only random scenes know.
BodyKind body_of_cases(const std::string& word) {
  static const std::map<std::string, BodyKind> bodies{{"", BodyKind::tetrahedra},
                                                      {"tetrahedra", BodyKind::tetrahedra},
                                                      {"affine", BodyKind::affine},
                                                      {"rigid", BodyKind::rigid}};
  const auto body = bodies.find(word);
  if (body != bodies.end()) return body->second;
  throw InputError("--body " + word, "known cases have blocks of one kind", "use it with --random");
}

ExitCode verify_cases(Request& request, bool json) {
  request.options.run.body = body_of_cases(request.body);
  const auto known =
      all_cases(request.samples.empty() ? installed_or("share/talus/samples", TALUS_SAMPLES) : request.samples);
  const auto cases = chosen_cases(known, request.names, request.all || request.list, request.options.run.body);
  if (request.list) {
    std::cout << (json ? list_json(cases) : list_text(cases));
    return done;
  }
  ListOfRuns<CaseResult> list;
  list.what = "cases";
  list.count = cases.size();
  list.run = [&](Progress& progress, const auto& ended) { verify(cases, request.options, progress, ended); };
  list.columns = case_columns();
  list.text = [&](const CaseResult& result) { return case_text(result, request.tables); };
  list.markdown = known_answers_page;
  list.json = [](const auto& results, bool complete) { return json_text(results, complete); };
  return run_list(list, request.markdown, json);
}

TrialOptions trial_options(const Request& request) {
  TrialOptions options{.threads = request.options.run.threads, .tolerance = request.options.run.tolerance};
  if (request.options.repeat) options.repeat_on = {1, 2};
  return options;
}

HardCasesRequest of_hard_cases(const Request& request) {
  return {request.names,         request.group,    request.all,           request.list,
          request.perturbations, request.markdown, trial_options(request)};
}

RandomRequest of_random(const Request& request) {
  RandomRequest random = request.random;
  random.bodies = request.body;
  random.list = request.list;
  random.markdown = request.markdown;
  random.options = trial_options(request);
  random.options.elsewhere = request.elsewhere;
  return random;
}

bool asks_for_random(const Request& request) { return request.random.count > 0 || !request.random.scenes.empty(); }

void add_tolerance(CLI::App& command, std::optional<double>& tolerance) {
  const auto check = [](const std::string& text) {
    return tolerance_from(text) ? std::string() : "write draft, standard, reference, or a number from 1e-12 to 0.01";
  };
  command
      .add_option_function<std::string>(
          "--tolerance", [&tolerance](const std::string& text) { tolerance = tolerance_from(text); },
          "Run with this solver.tolerance where a case or scene asks for none of its own")
      ->check(CLI::Validator(check, ""))
      ->type_name("draft|standard|reference|X");
}

/// Options that have to do with known cases alone.
void add_case_options(CLI::App& command, Request& request, CLI::Option* hard_cases) {
  command
      .add_option("--scale", request.options.run.scale,
                  "Run at another scale: of all lengths; times go with its root, stresses with itself")
      ->check(CLI::Validator(CLI::PositiveNumber).description(""))
      ->type_name("S")
      ->capture_default_str()
      ->excludes(hard_cases);
  command
      .add_option("--body", request.body,
                  "Run with blocks of this kind where tetrahedra stand otherwise (those cases that ask for no strain), "
                  "or draw random scenes with them; mixed: random scenes alone")
      ->check(CLI::IsMember({"rigid", "affine", "tetrahedra", "mixed"}).description(""))
      ->type_name("rigid|affine|tetrahedra|mixed")
      ->excludes(hard_cases);
  static const std::map<std::string, Preset> presets{{"talus", Preset::talus}, {"paper", Preset::paper}};
  command
      .add_option_function<std::string>(
          "--preset", [&request](const std::string& word) { request.options.run.preset = presets.at(word); },
          "Run by this scheme, whatever a case asks for: Talus's own or the paper's (solver.preset)")
      ->check(CLI::IsMember(presets).description(""))
      ->type_name("talus|paper")
      ->excludes(hard_cases);
  command.add_flag("--tables", request.tables, "Print the tables of cases that have more than numbers")
      ->excludes(hard_cases);
  command.add_option("--samples", request.samples, "Folder of the samples (default: the shipped ones)")
      ->type_name("DIR")
      ->excludes(hard_cases);
}

/// The hard cases instead of known answers.
CLI::Option* add_hard_case_options(CLI::App& command, Request& request) {
  auto* hard_cases = command.add_flag(
      "--hard-cases,--stability", request.hard_cases,
      "Run the scenes chosen to break contact codes instead: a row each with the deepest penetration and what energy "
      "grew by (both must stay below their limits), iterations a step, and in words what did not hold (--stability is "
      "the old name)");
  command.add_option("--group", request.group, "Only scenes of this group")->type_name("G")->needs(hard_cases);
  command
      .add_option("--perturbations,--nudge", request.perturbations,
                  "Run each scene N times more, with gravity and initial velocities greater by 1e-10 of themselves, by "
                  "2e-10, …: chance must not decide whether it holds (--nudge is the old name)")
      ->check(CLI::Validator(CLI::NonNegativeNumber).description(""))
      ->type_name("N")
      ->capture_default_str()
      ->needs(hard_cases);
  return hard_cases;
}

/// Scenes that chance draws instead of known answers.
void add_random_options(CLI::App& command, Request& request, CLI::Option* hard_cases) {
  auto* random = command
                     .add_option("--random", request.random.count,
                                 "Draw and run N random scenes instead: a row for each that does not hold, and a table "
                                 "of their families")
                     ->check(CLI::Validator(CLI::PositiveNumber).description(""))
                     ->type_name("N")
                     ->excludes(hard_cases);
  command
      .add_option("--seed", request.random.seed, "What random scenes are drawn from; now: a new one, which is printed")
      ->type_name("S|now")
      ->capture_default_str()
      ->needs(random);
  command
      .add_option("--family", request.random.families, "Only random scenes of these families (default: all in turn)")
      ->type_name("F")
      ->needs(random);
  command
      .add_option("--random-scene", request.random.scenes,
                  "Run these random scenes again, by their names: family, seed, number and, where it was chosen, body, "
                  "like impacts:17:42:rigid")
      ->type_name("NAME")
      ->excludes(hard_cases);
  command
      .add_flag("--other-settings", request.random.other_settings,
                "Solve the random scenes by solver settings of chance too, which must not change what holds")
      ->needs(random);
  command
      .add_flag("--elsewhere", request.elsewhere,
                "Run random scenes that have no blows again at another place, 5e6 m off and turned about the vertical, "
                "where displacements must be the same within 1e-9 of the size")
      ->excludes(hard_cases);
  command
      .add_option("--out", request.random.folder,
                  "Write random scenes that do not hold into this folder, as projects with what failed in comments")
      ->type_name("FOLDER");
}

}  // namespace

void add_verify(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand(
      "verify",
      "Run the cases with a known answer: expected, computed, error, tolerance, seconds and source.\n"
      "Error and tolerance are relative to the expected number; with ± they are in its unit");
  auto request = std::make_shared<Request>();
  command->add_option("NAME", request->names, "Cases or scenes to run (default: all that are quick)")->type_name("");
  command->add_flag("--all", request->all, "Also those that take minutes, and every row of those that are thinned");
  command->add_flag("--list", request->list, "List the cases there are and leave");
  CLI::Option* hard_cases = add_hard_case_options(*command, *request);
  add_case_options(*command, *request, hard_cases);
  add_random_options(*command, *request, hard_cases);
  add_threads(*command, request->options.run.threads);
  add_tolerance(*command, request->options.run.tolerance);
  command->add_flag(
      "--repeat", request->options.repeat,
      "Run each case again with 2 threads, which must give the same bits, and at a tenth of the scale, "
      "which must give the same relative numbers; hard cases with 1 and 2 threads, taken up anew in between");
  command
      ->add_option("--markdown", request->markdown,
                   "Write the results into this page, between its lines <!-- talus-cli verify: begin --> and "
                   "<!-- talus-cli verify: end -->")
      ->type_name("FILE");
  command->callback([&invocation, request] {
    request->options.run.thorough = request->all;
    if (request->elsewhere && !asks_for_random(*request))
      throw CLI::ValidationError("--elsewhere", "works with --random or --random-scene");
    invocation.run = [&invocation, request] {
      if (asks_for_random(*request)) return run_random(of_random(*request), invocation.json);
      return request->hard_cases ? run_hard_cases(of_hard_cases(*request), invocation.json)
                                 : verify_cases(*request, invocation.json);
    };
  });
}

}  // namespace talus::cli
