#pragma once

#include <memory>
#include <string>
#include <vector>

#include "measures/slide.hpp"
#include "measures/slipped_faces.hpp"
#include "session/results_measure.hpp"

namespace talus {

class Display;
enum class Theme;

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

/// On which planes its blocks slid on each other, and what these joints are called.
struct Slips {
  std::vector<SlippedFace> faces;
  std::vector<std::string> joint_names;  ///< as BlockSystem::joint_names
};

class SlippedJoints : public ResultsMeasure {
  Q_OBJECT
 public:
  /// Tells of a change where it is to be drawn in another theme, too.
  SlippedJoints(Playback& playback, const Display& display);

  /// Null where they are not looked for yet, or cannot be.
  const std::shared_ptr<const Slips>& slips() const { return slips_; }
  Theme theme() const;

 private:
  Work work() override;
  void forget() override { slips_.reset(); }

  const Display& display_;
  std::shared_ptr<const Slips> slips_;
};

}  // namespace talus
