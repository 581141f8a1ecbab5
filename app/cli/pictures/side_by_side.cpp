#include "side_by_side.hpp"

#include <memory>

#include "base/error.hpp"
#include "command.hpp"
#include "render/film/side_by_side.hpp"
#include "render/views/view_of_results.hpp"
#include "results/folder.hpp"

namespace talus::cli {

namespace {

struct Panel {
  explicit Panel(const std::filesystem::path& folder, const FrameChoice& choice)
      : results(folder),
        number(about(folder, [&] { return frame_index(results, choice); })),
        frame(std::make_shared<const Frame>(results.frame(number))) {}

  ResultReader results;
  int number;
  std::shared_ptr<const Frame> frame;
  std::unique_ptr<Scene> scene;
};

using Panels = std::vector<std::unique_ptr<Panel>>;

void make_scenes(const Panels& panels, const std::vector<std::filesystem::path>& folders, const Look& look) {
  const bool alone = panels.size() == 1;
  const std::vector<std::string> names = names_of_results(folders);
  ValueRange range;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    Panel& panel = *panels[i];
    SceneSettings settings = scene_settings(look, panel.results);
    if (!alone) settings.title = (look.title ? *look.title + ": " : "") + names[i];
    about(folders[i], [&] { need_field(panel.results.system(), *panel.frame, settings); });
    if (!alone && settings.field && !look.range)
      range.include(field_range(FieldValues(panel.results.system()), *panel.frame, *settings.field));
    panel.scene = std::make_unique<Scene>(panel.results.system(), settings);
    panel.scene->set_stage_names(panel.results.stage_names());
    panel.scene->set_frame(panel.frame);
    mark_troubles(look, panel.results, *panel.scene);
    tell_trails(panel.results, *panel.scene);
  }
  point_camera(look, panels.front()->results, *panels.front()->scene);
  if (range.empty()) return;
  for (const auto& panel : panels) {
    SceneSettings settings = panel->scene->settings();
    settings.range = legend_range(*settings.field, range);
    panel->scene->set_settings(settings);
  }
}

}  // namespace

void add_over(CLI::App& command, bool& over) {
  command.add_flag("--over", over, "Draw the edges of the second results' blocks over the first, not beside them");
}

void need_few(const std::vector<std::filesystem::path>& results, bool over) {
  constexpr std::size_t most_panels = 4;
  if (results.size() > most_panels)
    throw InputError("RESULTS", "four are drawn side by side at most", "draw the others into another picture");
  if (over && results.size() != 2)
    throw InputError("--over", "two results are drawn over each other", "name two, or leave --over out");
}

SideBySide draw_side_by_side(const std::vector<std::filesystem::path>& results, const FrameChoice& choice,
                             const Look& look, bool over, const PictureSize& size) {
  need_few(results, over);
  Panels panels;
  SideBySide drawn;
  for (const auto& folder : results) {
    panels.push_back(std::make_unique<Panel>(folder, choice));
    drawn.frames.push_back({folder, panels.back()->number, panels.back()->frame->time});
  }
  make_scenes(panels, results, look);
  std::vector<Scene*> scenes;
  for (const auto& panel : panels)
    if (scenes.empty() || !over) scenes.push_back(panel->scene.get());
  if (over)
    scenes.front()->set_ghost({borrowed(panels[1]->results.system()), panels[1]->frame, names_of_results(results)[1]});
  SideBySideView view(std::move(scenes), size.width, size.height, Sampling::best);
  view.hold_camera();
  drawn.picture = view.draw();
  return drawn;
}

}  // namespace talus::cli
