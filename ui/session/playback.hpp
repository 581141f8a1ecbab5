#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "jobs/live_frames.hpp"
#include "model/project.hpp"

namespace talus {

class Document;
class Messages;
class ResultsLoader;
struct ResultsIndex;

/// Of ascending times [s], not none, the number of the one that is nearest to `time`.
int nearestFrame(const std::vector<double>& times, double time);

/// Reads frames of results by their number; the results are opened on the thread that first asks.
std::function<std::shared_ptr<const Frame>(int)> framesOf(const std::filesystem::path& folder);

/// The frames of the run that goes on, or of the results that are open, and the one of them that is in view.
class Playback : public QObject {
  Q_OBJECT
 public:
  /// The frames are outdated while the document's project is another one; what cannot be read is said as a problem.
  Playback(Document& document, Messages& messages);
  ~Playback() override;

  /// The frames are of a run that goes on.
  bool isLive() const { return live_; }
  /// The frames belong to the project as it is now; false after it was edited, until that is undone.
  bool isCurrent() const;
  /// A results folder is being opened.
  bool isLoading() const { return loading_; }
  /// A frame has been asked for and is not there yet.
  bool isWaiting() const { return waiting_; }

  /// s, of each frame.
  const std::vector<double>& times() const { return times_; }
  /// Of the frame in view; -1 without one.
  int number() const { return number_; }
  std::shared_ptr<const Frame> frame() const { return frame_; }
  /// Those of a run that goes on which are kept.
  const std::vector<std::shared_ptr<const Frame>>& liveFrames() const { return liveFrames_.frames(); }
  /// s, of the frame in view; 0 without one.
  double time() const { return frame_ ? frame_->time : 0; }
  /// Shows a frame as soon as it is read; the newest of a live run is followed from then on.
  void showFrame(int number);
  /// The frame nearest to this moment, s.
  void showTime(double seconds);

  /// Where the results lie on disk; empty while there are none.
  const std::filesystem::path& folder() const { return folder_; }
  /// Reads frames for a film on another thread: from disk, or those of the live run that are kept.
  std::function<std::shared_ptr<const Frame>(int)> source() const;
  /// While a picture or film is written from the frames no run may replace them.
  void setExporting(bool exporting);
  bool isExporting() const { return exporting_; }

  /// No frames any more; the results folder is let go.
  void clear();
  /// Reads the results of the project as it is now, and shows their last frame.
  void open(const std::filesystem::path& folder);
  /// A run of the project as it is now begins, and brings its frames one by one.
  void beginRun();
  void add(const std::vector<std::shared_ptr<const Frame>>& frames);
  /// Where the run is, later than its last frame: in view while the newest is followed, until the next frame comes.
  void showMoment(std::shared_ptr<const Frame> moment);
  /// The run that brought the frames has come to nothing.
  void abandonRun() { live_ = false; }
  /// The results of the run take the place of its frames, at the moment that is in view.
  void endRun(const std::filesystem::path& folder);
  /// Another process has written more frames into the folder; who looks at the last one comes to the newest.
  void readAgain();

 signals:
  /// What the folder holds apart from its frames. `afterRun`: they are of the run that has just ended.
  void resultsOpened(const talus::ResultsIndex& index, bool afterRun);
  void framesChanged();  ///< how many, or which
  void frameChanged();   ///< the one in view

 private:
  void load(const std::filesystem::path& folder);
  void takeIndex(const ResultsIndex& index);
  void takeFrame(std::shared_ptr<const Frame> frame);

  const Document& document_;
  std::optional<Project> solved_;  ///< that the frames are of
  std::unique_ptr<ResultsLoader> loader_;
  LiveFrames liveFrames_;
  std::shared_ptr<const Frame> frame_;
  std::vector<double> times_;
  int number_ = -1;
  bool live_ = false, following_ = true, waiting_ = false, loading_ = false, exporting_ = false;
  std::optional<double> wantedTime_;  ///< to go on looking at when results take the place of live frames
  std::filesystem::path folder_;
};

}  // namespace talus
