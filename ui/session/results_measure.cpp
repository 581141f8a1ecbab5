#include "session/results_measure.hpp"

#include "base/error.hpp"
#include "session/playback.hpp"

namespace talus {

namespace {
constexpr int quiet_before_measuring = 50;  // ms: results that are opened tell of their frames more than once
}

ResultsMeasure::ResultsMeasure(Playback& playback) : playback_(playback), job_(quiet_before_measuring) {
  connect(&playback, &Playback::framesChanged, this, &ResultsMeasure::takeFrames);
}

void ResultsMeasure::setWatched(bool watched) {
  watched_ = watched;
  begin();
}

void ResultsMeasure::askAnew() {
  job_.cancel();
  isMeasured_ = false;
  problem_.clear();
  forget();
  begin();
  emit changed();
}

void ResultsMeasure::takeFrames() {
  const bool isOnDisk = !playback_.isLive() && !playback_.times().empty();
  const std::filesystem::path folder = isOnDisk ? playback_.folder() : std::filesystem::path();
  const std::size_t frames = isOnDisk ? playback_.times().size() : 0;
  if (folder == folder_ && frames == frames_) return;
  folder_ = folder;
  frames_ = frames;
  askAnew();
}

void ResultsMeasure::begin() {
  if (!watched_ || isMeasured_ || folder_.empty()) return;
  const Work wanted = work();
  if (!wanted) return;
  isMeasured_ = true;
  struct Outcome {
    std::function<void()> take;
    std::string problem;
  };
  job_.begin(
      [wanted, folder = folder_](Progress& progress) -> Outcome {
        try {
          return {wanted(ResultReader(folder), progress), {}};
        } catch (const InputError& error) {
          return {{}, error.what()};
        }
      },
      [this](const Outcome& outcome) {
        if (outcome.take) outcome.take();
        problem_ = QString::fromStdString(outcome.problem);
        emit changed();
      });
}

}  // namespace talus
