#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>

#include "jobs/latest_job.hpp"
#include "results/result_folder.hpp"

namespace talus {

class Playback;

/// Something that is measured of the results on disk, on a thread of its own, as long as someone looks at it.
class ResultsMeasure : public QObject {
  Q_OBJECT
 public:
  /// Measures as long as it is watched, and not otherwise.
  void setWatched(bool watched);
  /// It is being measured.
  bool isBusy() const { return job_.isBusy(); }
  /// Why it cannot be measured; empty where it can.
  const QString& problem() const { return problem_; }

 signals:
  void changed();

 protected:
  explicit ResultsMeasure(Playback& playback);
  /// What is asked for is another thing: what was measured is forgotten.
  void askAnew();

  /// Works on the measuring thread and returns what takes the result on the window's.
  using Work = std::function<std::function<void()>(const ResultReader& results, Progress& progress)>;

 private:
  /// What to do; empty where nothing is asked for.
  virtual Work work() = 0;
  virtual void forget() = 0;
  void takeFrames();
  void begin();

  Playback& playback_;
  bool watched_ = false, isMeasured_ = false;
  std::filesystem::path folder_;
  std::size_t frames_ = 0;
  QString problem_;
  LatestJob job_;
};

}  // namespace talus
