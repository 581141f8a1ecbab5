#include "session/measured_slide.hpp"

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

}  // namespace talus
