#include "render/scene/offscreen.hpp"
#include "render/scene/slope_view.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"
#include "results/field.hpp"

namespace talus::report {

namespace {

constexpr int picture_width = 1400, picture_height = 840;

std::string when(const RunRecord& run, const Frame& frame) {
  const auto& stages = run.results.stage_names();
  const auto stage = static_cast<std::size_t>(frame.stage);
  return given(frame.time) + "\u00a0s" +
         (stage < stages.size() && !stages[stage].empty() ? ", stage " + stages[stage] : "");
}

}  // namespace

Section pictures(const RunRecord& run) {
  const Frame first = run.results.frame(0);
  SceneSettings by_block;
  by_block.troubles = by_block.actions = false;
  SceneSettings by_displacement = by_block;
  by_displacement.field = field_named("displacement");

  Scene scene(run.system(), by_displacement);
  scene.set_stage_names(run.results.stage_names());
  scene.include_in_view(run.last);
  look_at_slope(scene, run.system(), &run.last);
  OffscreenView view(scene, picture_width, picture_height);
  scene.set_frame(std::make_shared<const Frame>(run.last));
  Picture last{view.draw(), "The last frame, " + when(run, run.last) + ": displacement since the start."};
  if (first.time == run.last.time) return {"The only frame", {std::move(last)}};
  scene.set_pose(scene.pose());  // both are seen from one place, beside the legend that the last one has
  scene.set_settings(by_block);
  scene.set_frame(std::make_shared<const Frame>(first));
  Picture before{view.draw(), "The first frame, " + when(run, first) + ": a colour a block, fixed rock grey."};
  return {"First and last frame", {std::move(before), std::move(last)}};
}

}  // namespace talus::report
