#include "session/measured_slide.hpp"

#include "session/display.hpp"

namespace talus {

void MeasuredSlide::set(const SlideSettings& settings) {
  if (settings == settings_) return;
  settings_ = settings;
  askAnew();
}

ResultsMeasure::Work MeasuredSlide::work() {
  return [this, settings = settings_](const ResultReader& results, Progress& progress) {
    const int last = static_cast<int>(results.frame_times().size()) - 1;
    const auto slide = std::make_shared<const Slide>(measure_slide(results, last, settings, progress));
    return [this, slide] { slide_ = slide; };
  };
}

SlippedJoints::SlippedJoints(Playback& playback, const Display& display) : ResultsMeasure(playback), display_(display) {
  connect(&display, &Display::themeChanged, this, &SlippedJoints::changed);
}

Theme SlippedJoints::theme() const { return display_.settings().theme; }

ResultsMeasure::Work SlippedJoints::work() {
  return [this](const ResultReader& results, Progress& progress) {
    const auto slips =
        std::make_shared<const Slips>(Slips{slipped_faces(results, progress), results.system().joint_names});
    return [this, slips] { slips_ = slips; };
  };
}

}  // namespace talus
