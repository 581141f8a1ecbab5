#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "render/film/movie.hpp"
#include "render/views/view_of_results.hpp"
#include "results/folder.hpp"
#include "side_by_side.hpp"
#include "text/json_text.hpp"
#include "text/table.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

struct AnimateOptions {
  std::vector<std::filesystem::path> results;
  std::filesystem::path out;
  FilmOptions film;
  PictureSize size{1280, 720};
  std::filesystem::path camera;
  std::string follow;
  Look look;
};

/// Results that are filmed, and what draws them.
struct FilmedRun {
  explicit FilmedRun(const std::filesystem::path& folder)
      : results(folder), frames(about(folder, [&] { return frame_index(results, {}) + 1; })) {}

  ResultReader results;
  int frames;
  std::unique_ptr<Scene> scene;
};
using FilmedRuns = std::vector<std::unique_ptr<FilmedRun>>;

/// One legend for the whole film: a colour means the same in every picture.
ValueRange range_of_all(const FilmedRuns& runs, const Field& field) {
  ValueRange range;
  for (const auto& run : runs) {
    const FieldValues fields(run->results.system());
    for (int i = 0; i < run->frames; ++i) range.include(field_range(fields, run->results.frame(i), field));
  }
  return legend_range(field, range);
}

void need_field_of_all(const AnimateOptions& options, const FilmedRuns& runs, const SceneSettings& settings) {
  for (std::size_t i = 0; i < runs.size(); ++i)
    about(options.results[i],
          [&] { need_field(runs[i]->results.system(), runs[i]->results.frame(runs[i]->frames - 1), settings); });
}

void make_scenes_by_options(const AnimateOptions& options, const FilmedRuns& runs) {
  const std::vector<std::string> names = names_of_results(options.results);
  std::optional<ValueRange> range;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    FilmedRun& run = *runs[i];
    SceneSettings settings = scene_settings(options.look, run.results);
    need_field_of_all(options, runs, settings);
    if (settings.field && !settings.range && !range) range = range_of_all(runs, *settings.field);
    if (range) settings.range = range;
    if (runs.size() > 1) settings.title = (options.look.title ? *options.look.title + ": " : "") + names[i];
    run.scene = std::make_unique<Scene>(run.results.system(), settings);
    run.scene->set_stage_names(run.results.stage_names());
    for (int k = 0; k < run.frames; ++k) run.scene->include_in_view(run.results.frame(k));
    mark_troubles(options.look, run.results, *run.scene);
    tell_trails(run.results, *run.scene);
  }
  point_camera(options.look, runs.front()->results, *runs.front()->scene);
}

/// What the view file shows: the results that are named, and beside them those that it compares with them.
SavedView take_view(AnimateOptions& options) {
  if (options.results.size() > 1)
    throw InputError("--view-file", "a view is filmed of one results folder",
                     "name that alone; what it is compared with is in the view");
  SavedView view = read_view(options.look.view_file);
  for (const ViewBeside& one : view.beside) options.results.push_back(one.results);
  options.film.over = options.film.over || (view.beside.size() == 1 && view.beside.front().over);
  return view;
}

void make_scenes_as_saved(const AnimateOptions& options, SavedView view, const FilmedRuns& runs) {
  need_field_of_all(options, runs, view.settings);
  if (view.settings.field && !view.settings.range) view.settings.range = range_of_all(runs, *view.settings.field);
  const std::vector<std::string> names = names_of_results(options.results);
  if (runs.size() > 1) view.settings.title = names.front();
  FilmedRun& first = *runs.front();
  first.scene = about(options.look.view_file, [&] {
    return scene_of_view(view, first.results, monitors_of(options.results.front(), first.results), false);
  });
  for (std::size_t i = 1; i < runs.size(); ++i) {
    FilmedRun& run = *runs[i];
    run.scene = std::make_unique<Scene>(run.results.system(), settings_beside(first.scene->settings(), names[i]));
    run.scene->set_stage_names(run.results.stage_names());
    run.scene->set_pose(view.camera);
  }
}

CameraMoves moves_of(const AnimateOptions& options, const BlockSystem& system) {
  CameraMoves moves = options.film.camera;
  if (!options.camera.empty()) moves.keys = read_camera_keys(options.camera);
  if (options.follow.empty()) return moves;
  const auto found = std::ranges::find(system.blocks, options.follow, &Block::name);
  if (found == system.blocks.end())
    throw InputError("block " + options.follow, "the results hold no block of that name", "info lists them");
  moves.follow = static_cast<int>(found - system.blocks.begin());
  return moves;
}

ExitCode animate(AnimateOptions options, bool json) {
  catch_interrupts();
  std::optional<SavedView> view;
  if (!options.look.view_file.empty()) view = take_view(options);
  need_few(options.results, options.film.over);
  FilmedRuns runs;
  for (const auto& folder : options.results) runs.push_back(std::make_unique<FilmedRun>(folder));
  view ? make_scenes_as_saved(options, *view, runs) : make_scenes_by_options(options, runs);
  const std::vector<std::string> names = names_of_results(options.results);
  std::vector<Filmed> films;
  for (const auto& run : runs)
    films.push_back({*run->scene, run->results.system(), run->results.frame_times(),
                     [&run](int i) { return std::make_shared<const Frame>(run->results.frame(i)); },
                     names[films.size()]});
  FilmOptions film = options.film;
  film.width = options.size.width;
  film.height = options.size.height;
  film.camera = about(options.results.front(), [&] { return moves_of(options, runs.front()->results.system()); });
  int pictures = 0;
  {
    TerminalProgress progress;
    pictures = render_film(films, film, options.out, progress);
  }
  int count = 0;
  for (const auto& run : runs) count += run->frames;
  const int fps = film.fps;
  const double seconds = static_cast<double>(pictures) / fps;

  if (json) {
    const nlohmann::ordered_json result = {{"film", options.out.string()},
                                           {"width", options.size.width},
                                           {"height", options.size.height},
                                           {"fps", fps},
                                           {"frames", count},
                                           {"pictures", pictures},
                                           {"seconds", seconds},
                                           {"speed", film.speed}};
    std::cout << json_text(result) << '\n';
  } else {
    const std::string speed = speed_text(film.speed);
    std::cout << options.out.string() << ": " << number(seconds, 3) << " s, " << pictures << " pictures of " << count
              << (count == 1 ? " frame, " : " frames, ") << (speed.empty() ? "real time" : speed) << '\n';
  }
  return done;
}

}  // namespace

void add_animate(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand(
      "animate", "Film all frames as MP4 or GIF, also of several results side by side; needs no display");
  auto options = std::make_shared<AnimateOptions>();
  command
      ->add_option("RESULTS", options->results,
                   "Results folder, also of a run that goes on or was killed; up to four are filmed side by side")
      ->required()
      ->type_name("DIR");
  command->add_option("--out", options->out, "Film to write")->required()->type_name("F.mp4|F.gif");
  command
      ->add_option("--speed", options->film.speed,
                   "Seconds of the model in a second of film: 1 is real time, 0.1 slows down")
      ->check(CLI::Validator(CLI::PositiveNumber).description(""))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--from", options->film.from, "Where the film begins, s of the model")->type_name("T");
  command->add_option("--to", options->film.to, "Where it ends")->type_name("T");
  command
      ->add_option("--turn", options->film.camera.turn,
                   "The camera goes round the rock by so many degrees during the film")
      ->type_name("DEG");
  command->add_option("--follow", options->follow, "The camera goes along with this block")->type_name("BLOCK");
  command
      ->add_option("--camera", options->camera,
                   "The camera goes through the keys of this table: time [s], where it stands (x, y, z), where it "
                   "looks to (x, y, z)")
      ->type_name("KEYS.csv");
  add_over(*command, options->film.over);
  command->add_option("--fps", options->film.fps, "Pictures a second")
      ->check(CLI::Range(1, 120).description(""))
      ->type_name("N")
      ->capture_default_str();
  add_size(*command, options->size);
  add_look(*command, options->look);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return animate(*options, invocation.json); };
  });
}

}  // namespace talus::cli
