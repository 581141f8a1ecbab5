#include "render/views/view_of_results.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "fields/field_values.hpp"
#include "measures/block_trails.hpp"
#include "results/folder.hpp"

namespace talus {

void need_field(const BlockSystem& system, const Frame& frame, const SceneSettings& settings) {
  if (!settings.field) return;
  if (const std::string absent = why_absent(system, frame, *settings.field); !absent.empty())
    throw InputError("field " + std::string(settings.field->name), absent, "solve the project again");
}

std::unique_ptr<Scene> scene_of_view(const SavedView& view, const ResultReader& results,
                                     std::vector<ActionGlyph> monitors, bool pixels) {
  SavedView shown = view;
  shown.settings.smooth_outlines = !pixels;
  if (!pixels) {
    shown.settings.text_height = 0;
    shown.covered.clear();
  }
  auto scene = std::make_unique<Scene>(results.system(), shown.settings);
  scene->set_stage_names(results.stage_names());
  scene->set_actions(std::move(monitors));
  if (shown.settings.troubles)
    if (const auto report = results.report()) scene->set_troubles(report->troubles);
  if (shown.settings.trails != Trails::none) {
    NoProgress quiet;
    scene->set_trails(std::make_shared<const BlockTrails>(block_trails(results, quiet)));
  }
  show_view(shown, results.system(), *scene);
  return scene;
}

namespace {

/// Throws InputError where there is none.
int frame_nearest_to(const std::optional<double>& time, const ResultReader& results) {
  const std::vector<double>& times = results.frame_times();
  if (times.empty()) throw InputError("frames", "the results hold no frame yet", "wait for the run to write one");
  if (!time) return static_cast<int>(times.size()) - 1;
  const auto nearest = std::ranges::min_element(times, {}, [&](double one) { return std::abs(one - *time); });
  return static_cast<int>(nearest - times.begin());
}

SceneBeside scene_beside(const std::filesystem::path& folder, const SceneSettings& settings, const CameraPose& pose,
                         double time) {
  auto results = std::make_unique<ResultReader>(folder);
  const int number = frame_nearest_to(time, *results);
  auto frame = std::make_shared<const Frame>(results->frame(number));
  need_field(results->system(), *frame, settings);
  auto scene = std::make_unique<Scene>(results->system(), settings);
  scene->set_stage_names(results->stage_names());
  scene->set_frame(frame);
  scene->set_pose(pose);
  return {folder, std::move(results), number, std::move(frame), std::move(scene)};
}

}  // namespace

int frame_of_view(const SavedView& view, const ResultReader& results) { return frame_nearest_to(view.time, results); }

SceneSettings settings_beside(const SceneSettings& view, const std::string& name) {
  SceneSettings settings = view;
  settings.title = name;
  settings.legend = settings.triad = settings.scale_bar = false;  // the view beside it has the same
  settings.places.clear();                                        // those are of the other's blocks
  settings.block_colours.reset();
  return settings;
}

std::vector<SceneBeside> scenes_beside(const SavedView& view, const std::filesystem::path& folder, double time,
                                       Scene& first) {
  std::vector<SceneBeside> beside;
  if (view.beside.empty()) return beside;
  std::vector<std::filesystem::path> folders{folder};
  for (const ViewBeside& one : view.beside) folders.push_back(one.results);
  const std::vector<std::string> names = names_of_results(folders);
  SceneSettings settings = first.settings();
  settings.title = names.front();
  first.set_settings(settings);
  for (std::size_t i = 0; i < view.beside.size(); ++i) {
    const std::filesystem::path& results = view.beside[i].results;
    try {
      beside.push_back(scene_beside(results, settings_beside(settings, names[i + 1]), view.camera, time));
    } catch (const InputError& error) {
      throw InputError(results.string() + ": " + error.place(), error.problem(), error.remedy());
    }
    if (view.beside[i].over)
      first.set_ghost({borrowed(beside.back().results->system()), beside.back().frame, names[i + 1]});
  }
  return beside;
}

}  // namespace talus
