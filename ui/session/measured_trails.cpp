#include "session/measured_trails.hpp"

#include "session/display.hpp"

namespace talus {

MeasuredTrails::MeasuredTrails(Playback& playback, Display& display) : ResultsMeasure(playback) {
  connect(&display, &Display::changed, this,
          [this, &display] { setWatched(display.settings().trails != Trails::none); });
}

ResultsMeasure::Work MeasuredTrails::work() {
  return [this](const ResultReader& results, Progress& progress) {
    const auto trails = std::make_shared<const BlockTrails>(block_trails(results, progress));
    return [this, trails] { trails_ = trails; };
  };
}

}  // namespace talus
