#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

#include "base/error.hpp"
#include "command.hpp"
#include "options.hpp"
#include "studies/engine_choice.hpp"
#include "studies/studies.hpp"
#include "study/accuracy/accuracy_files.hpp"
#include "study/accuracy/choice.hpp"
#include "study/accuracy/study_record.hpp"
#include "text/study_chart.hpp"
#include "text/study_text.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

struct AccuracyOptions {
  StudyRequest request;
  std::filesystem::path out;
  std::vector<std::string> axes, values;
  std::string target, measure;
  EngineChoice engine;
  PictureSize size{1600, 1000};
  Theme theme = Theme::light;
};

std::filesystem::path study_folder(const AccuracyOptions& options) {
  return options.out.empty() ? study_folder_of(options.request.project_file) : options.out;
}

StudyFolder open_study(const AccuracyOptions& options) {
  if (options.request.project_file == "-")
    throw InputError("-", "a study goes on by the name of its project", "write the project into a file");
  const bool as_it_is =
      options.engine.collect && options.measure.empty() && options.axes.empty() && options.values.empty();
  if (as_it_is) return StudyFolder(study_folder(options));
  StudyRequest request = options.request;
  request.program = TALUS_VERSION;
  request.wish = parse_ladder_wish(options.axes, options.values);
  if (!options.measure.empty()) request.measure = study_measure_from(options.measure);
  return StudyFolder(study_folder(options), about(request.project_file, [&] { return make_plan(request); }),
                     options.engine.restart);
}

void write_products(const AccuracyStudy& study, const StudyFolder& folder, const AccuracyOptions& options) {
  write_accuracy_files(study, folder);
  write_png(draw_cost_chart(cost_plot(study, options.theme), options.size.width, options.size.height),
            folder.path() / "accuracy.png");
}

/// Done where every run has ended and the target, if there is one, is met.
ExitCode accuracy(const AccuracyOptions& options, bool json) {
  catch_interrupts();
  const std::optional<double> target =
      options.target.empty() ? std::nullopt : std::optional<double>(parse_target(options.target));
  const StudyFolder folder = open_study(options);
  if (!make_runs(folder, options.engine)) return failed;
  const AccuracyStudy study = evaluate(folder, target);
  write_products(study, folder, options);
  if (json)
    std::cout << accuracy_json(study);
  else
    std::cout << study_text(study) << "Study in " << folder.path().string() << '\n';
  return tell_missing(folder) && (!target || study.recommended >= 0) ? done : failed;
}

void add_ladder_options(CLI::App& command, AccuracyOptions& options) {
  command
      .add_option("--axes", options.axes,
                  "What to vary: body, strain, integrator, time_step, static_step, mesh_size, contact, "
                  "contact_stiffness, penetration_tolerance, tolerance, scheme, with commas between (default: those of "
                  "--values, else all)")
      ->allow_extra_args(false)
      ->type_name("A,B,…");
  command
      .add_option(
          "--values", options.values,
          "Vary this axis, by these values: time_step=4,2,1,0.5 (factors of the project's own), body=rigid,affine "
          "or penetration_tolerance=off,1e-4; may be given again")
      ->allow_extra_args(false)
      ->type_name("AXIS=V,W,…");
  command
      .add_option("--target", options.target,
                  "Error to meet, like 1% or 0.01: names the cheapest setting that does and writes it as a project")
      ->type_name("ERROR");
}

void add_measure_options(CLI::App& command, AccuracyOptions& options) {
  command
      .add_option("--repeat", options.request.repeats,
                  "Run each setting N times, hardly changed: errors are of the means, and their spread is told")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--measure", options.measure,
                  "What errors are of: displacement, run-out, deposit, start, end or stress, each from the finest run "
                  "(default: the project's expect lines, else displacement)")
      ->type_name("WHAT");
}

}  // namespace

void add_accuracy_study(CLI::App& study, Invocation& invocation) {
  auto* command = study.add_subcommand(
      "accuracy",
      "Solve a project under a ladder of settings; tell error against processor time, orders of\n"
      "convergence and the cheapest setting that is good enough. A study that was stopped goes on where it was.");
  auto options = std::make_shared<AccuracyOptions>();
  command->add_option("PROJECT", options->request.project_file, "Project file (.talus)")->required()->type_name("PATH");
  command->add_flag("--allow-outside", options->request.allow_outside,
                    "Let the project name files outside its own folder");
  command
      ->add_option("--out", options->out, "Folder of the study (default: NAME.accuracy beside the project NAME.talus)")
      ->type_name("DIR");
  add_ladder_options(*command, *options);
  add_measure_options(*command, *options);
  add_engine(*command, options->engine);
  add_size(*command, options->size);
  add_theme(*command, options->theme);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return accuracy(*options, invocation.json); };
  });
}

}  // namespace talus::cli
