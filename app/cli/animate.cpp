#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "render/film/movie.hpp"
#include "render/views/view_of_results.hpp"
#include "text/json_text.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

struct AnimateOptions {
  std::filesystem::path results, out;
  int fps = 25;
  PictureSize size{1280, 720};
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
  about(options.results, [&] { need_field(results.frame(count - 1), settings); });
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
  about(options.results, [&] { need_field(results.frame(count - 1), view.settings); });
  if (view.settings.field && !view.settings.range)
    view.settings.range = range_of_all(results, count, *view.settings.field);
  return about(options.look.view_file,
               [&] { return scene_of_view(view, results, monitors_of(options.results, results), false); });
}

ExitCode animate(const AnimateOptions& options, bool json) {
  catch_interrupts();
  const ResultReader results(options.results);
  const int count = about(options.results, [&] { return frame_index(results, {}) + 1; });
  const std::unique_ptr<Scene> scene = options.look.view_file.empty() ? scene_by_options(options, results, count)
                                                                      : scene_as_saved(options, results, count);
  const FilmOptions film{options.size.width, options.size.height, options.fps};
  {
    TerminalProgress progress;
    render_film(
        *scene, count, [&](int i) { return std::make_shared<const Frame>(results.frame(i)); }, options.out, film,
        progress);
  }

  if (json) {
    const nlohmann::ordered_json result = {{"film", options.out.string()},
                                           {"width", film.width},
                                           {"height", film.height},
                                           {"fps", film.fps},
                                           {"frames", count}};
    std::cout << json_text(result) << '\n';
  } else {
    std::cout << options.out.string() << ": " << count << " frames, " << film.fps << " a second\n";
  }
  return done;
}

}  // namespace

void add_animate(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("animate", "Film all frames as MP4 or GIF; needs no display");
  auto options = std::make_shared<AnimateOptions>();
  add_results(*command, options->results);
  command->add_option("--out", options->out, "Film to write")->required()->type_name("F.mp4|F.gif");
  command->add_option("--fps", options->fps, "Pictures a second")
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
