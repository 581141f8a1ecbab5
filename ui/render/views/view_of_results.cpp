#include "render/views/view_of_results.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "measures/block_trails.hpp"
#include "render/scene/offscreen.hpp"

namespace talus {

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

int frame_of_view(const SavedView& view, const ResultReader& results) {
  const std::vector<double>& times = results.frame_times();
  if (times.empty()) throw InputError("frames", "the results hold no frame yet", "wait for the run to write one");
  if (!view.time) return static_cast<int>(times.size()) - 1;
  const auto nearest = std::ranges::min_element(times, {}, [&](double time) { return std::abs(time - *view.time); });
  return static_cast<int>(nearest - times.begin());
}

Image draw_view(Scene& scene, const SavedView& view) {
  return OffscreenView(scene, view.width, view.height, Sampling::fast).draw();
}

}  // namespace talus
