#include "pictures/drawing.hpp"

#include <CLI/CLI.hpp>

#include <memory>

#include "command.hpp"
#include "render/film/side_by_side.hpp"
#include "render/views/view_of_results.hpp"

namespace talus::cli {

namespace {

SideBySide drawn_as_saved(const Drawing& drawing) {
  if (drawing.results.size() > 1)
    throw InputError("--view-file", "a view is drawn of one results folder",
                     "name that alone; what it is compared with is in the view");
  const std::filesystem::path& folder = drawing.results.front();
  const ResultReader results(folder);
  const SavedView view = read_view(drawing.look.view_file);
  const bool other_frame = drawing.choice.time || drawing.choice.frame;
  const int index =
      about(folder, [&] { return other_frame ? frame_index(results, drawing.choice) : frame_of_view(view, results); });
  const auto frame = std::make_shared<const Frame>(results.frame(index));
  about(folder, [&] { need_field(results.system(), *frame, view.settings); });
  const bool as_it_was = !drawing.has_size;
  const auto scene = about(drawing.look.view_file,
                           [&] { return scene_of_view(view, results, monitors_of(folder, results), as_it_was); });
  scene->set_frame(frame);
  const std::vector<SceneBeside> beside =
      about(drawing.look.view_file, [&] { return scenes_beside(view, folder, frame->time, *scene); });
  std::vector<Scene*> scenes{scene.get()};
  std::vector<DrawnFrame> frames{{folder, index, frame->time}};
  for (const SceneBeside& one : beside) {
    scenes.push_back(one.scene.get());
    frames.push_back({one.folder, one.number, one.frame->time});
  }
  const PictureSize size = as_it_was ? PictureSize{view.width, view.height} : drawing.size;
  SideBySideView whole(std::move(scenes), size.width, size.height, as_it_was ? Sampling::fast : Sampling::best);
  return {whole.draw(), std::move(frames)};
}

}  // namespace

void add_drawing(CLI::App& command, Drawing& drawing) {
  command
      .add_option("RESULTS", drawing.results,
                  "Results folder, also of a run that goes on or was killed; up to four are drawn side by side")
      ->required()
      ->type_name("DIR");
  add_frame_choice(command, drawing.choice);
  add_size(command, drawing.size)->each([&drawing](const std::string&) { drawing.has_size = true; });
  add_over(command, drawing.over);
  add_look(command, drawing.look);
}

SideBySide draw(const Drawing& drawing) {
  return drawing.look.view_file.empty()
             ? draw_side_by_side(drawing.results, drawing.choice, drawing.look, drawing.over, drawing.size)
             : drawn_as_saved(drawing);
}

}  // namespace talus::cli
