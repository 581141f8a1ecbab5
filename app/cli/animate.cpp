#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "render/film/movie.hpp"
#include "render/views/view_of_results.hpp"
#include "text/json_text.hpp"
#include "text/table.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

struct AnimateOptions {
  std::filesystem::path results, out;
  FilmOptions film;
  PictureSize size{1280, 720};
  std::filesystem::path camera;
  std::string follow;
  Look look;
};

/// One legend for the whole film: a colour means the same in every picture.
ValueRange range_of_all(const ResultReader& results, int count, const Field& field) {
  ValueRange range;
  const FieldValues fields(results.system());
  for (int i = 0; i < count; ++i) range.include(field_range(fields, results.frame(i), field));
  return legend_range(field, range);
}

std::unique_ptr<Scene> scene_by_options(const AnimateOptions& options, const ResultReader& results, int count) {
  SceneSettings settings = scene_settings(options.look, results);
  about(options.results, [&] { need_field(results.system(), results.frame(count - 1), settings); });
  if (settings.field && !settings.range) settings.range = range_of_all(results, count, *settings.field);
  auto scene = std::make_unique<Scene>(results.system(), settings);
  scene->set_stage_names(results.stage_names());
  for (int i = 0; i < count; ++i) scene->include_in_view(results.frame(i));
  mark_troubles(options.look, results, *scene);
  point_camera(options.look, results, *scene);
  return scene;
}

std::unique_ptr<Scene> scene_as_saved(const AnimateOptions& options, const ResultReader& results, int count) {
  SavedView view = read_view(options.look.view_file);
  about(options.results, [&] { need_field(results.system(), results.frame(count - 1), view.settings); });
  if (view.settings.field && !view.settings.range)
    view.settings.range = range_of_all(results, count, *view.settings.field);
  return about(options.look.view_file,
               [&] { return scene_of_view(view, results, monitors_of(options.results, results), false); });
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

ExitCode animate(const AnimateOptions& options, bool json) {
  catch_interrupts();
  const ResultReader results(options.results);
  const int count = about(options.results, [&] { return frame_index(results, {}) + 1; });
  const std::unique_ptr<Scene> scene = options.look.view_file.empty() ? scene_by_options(options, results, count)
                                                                      : scene_as_saved(options, results, count);
  Filmed film{*scene, results.system(), results.frame_times(),
              [&](int i) { return std::make_shared<const Frame>(results.frame(i)); }, options.film};
  film.options.width = options.size.width;
  film.options.height = options.size.height;
  film.options.camera = about(options.results, [&] { return moves_of(options, results.system()); });
  int pictures = 0;
  {
    TerminalProgress progress;
    pictures = render_film(film, options.out, progress);
  }
  const int fps = film.options.fps;
  const double seconds = static_cast<double>(pictures) / fps;

  if (json) {
    const nlohmann::ordered_json result = {{"film", options.out.string()},
                                           {"width", options.size.width},
                                           {"height", options.size.height},
                                           {"fps", fps},
                                           {"frames", count},
                                           {"pictures", pictures},
                                           {"seconds", seconds},
                                           {"speed", film.options.speed}};
    std::cout << json_text(result) << '\n';
  } else {
    const std::string speed = speed_text(film.options.speed);
    std::cout << options.out.string() << ": " << number(seconds, 3) << " s, " << pictures << " pictures of " << count
              << (count == 1 ? " frame, " : " frames, ") << (speed.empty() ? "real time" : speed) << '\n';
  }
  return done;
}

}  // namespace

void add_animate(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("animate", "Film all frames as MP4 or GIF; needs no display");
  auto options = std::make_shared<AnimateOptions>();
  add_results(*command, options->results);
  command->add_option("--out", options->out, "Film to write")->required()->type_name("F.mp4|F.gif");
  command
      ->add_option("--speed", options->film.speed,
                   "Seconds of the model in a second of film: 1 is real time, 0.1 slows down")
      ->check(CLI::Validator(CLI::PositiveNumber).description(""))
      ->type_name("N")
      ->capture_default_str();
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
