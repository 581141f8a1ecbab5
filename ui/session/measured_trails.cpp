#include "session/measured_trails.hpp"

#include "session/current_project.hpp"
#include "session/display.hpp"
#include "session/playback.hpp"

namespace talus {

MeasuredTrails::MeasuredTrails(CurrentProject& project, Playback& playback, Display& display)
    : ResultsMeasure(playback), project_(project), playback_(playback), display_(display) {
  connect(&display, &Display::changed, this, [this] {
    setWatched(display_.settings().trails != Trails::none);
    followRun();
  });
  connect(&playback, &Playback::framesChanged, this, &MeasuredTrails::followRun);
}

ResultsMeasure::Work MeasuredTrails::work() {
  return [this](const ResultReader& results, Progress& progress) {
    const auto trails = std::make_shared<const BlockTrails>(block_trails(results, progress));
    return [this, trails] { trails_ = trails; };
  };
}

/// Those of a run that has just ended are seen until its results are measured.
void MeasuredTrails::forget() {
  if (!live_) trails_.reset();
}

void MeasuredTrails::followRun() {
  const auto system = project_.system();
  const bool goesOn = playback_.isLive() && system && display_.settings().trails != Trails::none;
  if (!goesOn) {
    live_.reset();
    if (playback_.times().empty()) trails_.reset();
    return;
  }
  if (!live_ || live_->system() != system) live_ = std::make_unique<TrailTracer>(system);
  const auto& before = live_->trails().times;
  const std::size_t count = before.size();
  for (const auto& frame : playback_.liveFrames())
    if (before.empty() || frame->time > before.back()) live_->add(*frame);
  if (before.size() == count) return;
  trails_ = std::make_shared<const BlockTrails>(live_->trails());
  emit changed();
}

}  // namespace talus
