#pragma once

#include <memory>

#include "measures/slide.hpp"
#include "session/results_measure.hpp"

namespace talus {

/// What the slide whose results are open has come to at its end.
class MeasuredSlide : public ResultsMeasure {
  Q_OBJECT
 public:
  explicit MeasuredSlide(Playback& playback) : ResultsMeasure(playback) {}

  const SlideSettings& settings() const { return settings_; }
  void set(const SlideSettings& settings);
  /// Null where nothing is measured yet, or cannot be.
  const std::shared_ptr<const Slide>& slide() const { return slide_; }

 private:
  Work work() override;
  void forget() override { slide_.reset(); }

  SlideSettings settings_;
  std::shared_ptr<const Slide> slide_;
};

}  // namespace talus
