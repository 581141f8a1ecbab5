#include <CLI/CLI.hpp>

#include <cstdlib>
#include <iostream>
#include <memory>

#include "base/error.hpp"
#include "command.hpp"
#include "options.hpp"
#include "study/accuracy/accuracy_files.hpp"
#include "study/accuracy/choice.hpp"
#include "study/accuracy/local_engine.hpp"
#include "study/accuracy/slurm_engine.hpp"
#include "study/accuracy/study_record.hpp"
#include "text/study_chart.hpp"
#include "text/study_text.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

struct AccuracyOptions {
  StudyRequest request;
  std::filesystem::path out;
  std::vector<std::string> axes, values, sbatch;
  std::string target, measure, engine = "local";
  int jobs = 0;
  bool restart = false, collect = false;
  PictureSize size{1600, 1000};
  Theme theme = Theme::light;
};

std::filesystem::path this_program() { return std::filesystem::read_symlink("/proc/self/exe"); }

std::filesystem::path study_folder(const AccuracyOptions& options) {
  return options.out.empty() ? study_folder_of(options.request.project_file) : options.out;
}

StudyFolder open_study(const AccuracyOptions& options) {
  if (options.request.project_file == "-")
    throw InputError("-", "a study goes on by the name of its project", "write the project into a file");
  const bool as_it_is = options.collect && options.measure.empty() && options.axes.empty() && options.values.empty();
  if (as_it_is) return StudyFolder(study_folder(options));
  StudyRequest request = options.request;
  request.program = TALUS_VERSION;
  request.wish = parse_ladder_wish(options.axes, options.values);
  if (!options.measure.empty()) request.measure = study_measure_from(options.measure);
  return StudyFolder(study_folder(options), about(request.project_file, [&] { return make_plan(request); }),
                     options.restart);
}

void compute(const StudyFolder& study, const AccuracyOptions& options) {
  // BLAS reads it when a program starts: that the runs have one thread each is said here.
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  TerminalProgress progress;
  if (options.engine == "slurm")
    run_by_slurm(study, {.program = this_program(), .arguments = options.sbatch}, progress);
  else
    run_locally(study, {this_program(), options.jobs > 0 ? options.jobs : free_cores()}, progress);
}

/// False where it was interrupted.
bool compute_and_tell(const StudyFolder& study, const AccuracyOptions& options) {
  try {
    compute(study, options);
    return true;
  } catch (const Cancelled&) {
    std::cerr << "talus-cli: stopped with " << study.missing_runs().size() << " of " << study.plan().runs()
              << " runs left"
              << (options.engine == "slurm" ? ", which Slurm goes on with; the same command collects them\n"
                                            : "; the same command goes on\n");
    return false;
  }
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
  if (!options.collect && !compute_and_tell(folder, options)) return failed;
  const AccuracyStudy study = evaluate(folder, target);
  write_products(study, folder, options);
  if (json)
    std::cout << accuracy_json(study);
  else
    std::cout << study_text(study) << "Study in " << folder.path().string() << '\n';
  const std::size_t missing = folder.missing_runs().size();
  if (missing > 0)
    std::cerr << "talus-cli: " << missing << " runs have no result yet; runs/*.log says what came up, and the same "
              << "command without --collect tries them again\n";
  return missing == 0 && (!target || study.recommended >= 0) ? done : failed;
}

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

ExitCode run_one(const std::filesystem::path& folder, int number) {
  catch_interrupts();
  const StudyFolder study(folder);
  const int count = study.plan().runs();
  if (number < 0 || number >= count)
    throw InputError("run " + std::to_string(number), "the study has runs 0 to " + std::to_string(count - 1),
                     "choose one of these");
  PlainProgress progress;
  perform_study_run(study, number, progress);
  return done;
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

void add_engine_options(CLI::App& command, AccuracyOptions& options) {
  command.add_option("--engine", options.engine, "Where runs go on: processes of this machine, or a Slurm job array")
      ->check(CLI::IsMember({"local", "slurm"}).description(""))
      ->type_name("local|slurm")
      ->capture_default_str();
  command.add_option("--jobs", options.jobs, "Runs at a time, each on one thread (default: cores that are free)")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N");
  command
      .add_option("--sbatch", options.sbatch,
                  "Another argument for sbatch, like --sbatch=--partition=long; may be "
                  "given again")
      ->allow_extra_args(false)
      ->type_name("ARG");
  command.add_flag("--restart", options.restart, "Begin anew in a folder that holds a study");
  command.add_flag("--collect", options.collect, "Run nothing: draw up what there is");
}

void add_accuracy(CLI::App& study, Invocation& invocation) {
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
  add_engine_options(*command, *options);
  add_size(*command, options->size);
  add_theme(*command, options->theme);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return accuracy(*options, invocation.json); };
  });
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
  auto* command = program.add_subcommand("study", "Solve a project many times: what accuracy costs");
  command->require_subcommand(1);
  add_accuracy(*command, invocation);
  add_run(*command, invocation);
  for (CLI::App* study : command->get_subcommands({})) study->fallthrough();
}

}  // namespace talus::cli
