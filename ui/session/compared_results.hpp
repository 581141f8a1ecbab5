#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <vector>

#include "jobs/results_loader.hpp"

namespace talus {

class Messages;
class Playback;
struct ViewBeside;

/// Other results that are looked at beside those that are open, at the same moment: the frame nearest to it.
class ComparedRun : public QObject {
  Q_OBJECT
 public:
  ComparedRun(const std::filesystem::path& folder, Playback& playback);

  /// Null until they are open.
  const std::shared_ptr<const ResultsIndex>& results() const { return index_; }
  /// Null until it has been read.
  const std::shared_ptr<const Frame>& frame() const { return frame_; }

 signals:
  void opened();
  void failed(const talus::InputError& error);
  void frameChanged();

 private:
  void follow();

  Playback& playback_;
  std::shared_ptr<const ResultsIndex> index_;
  std::shared_ptr<const Frame> frame_;
  ResultsLoader loader_;
};

/// All that is compared with the results that are open, up to three runs.
class ComparedResults : public QObject {
  Q_OBJECT
 public:
  ComparedResults(Playback& playback, Messages& messages);

  /// What cannot be read is said as a problem, and so is a fourth.
  void open(const std::filesystem::path& folder);
  void close(const ComparedRun& run);
  /// What a saved view shows beside, and nothing else.
  void show(const std::vector<ViewBeside>& beside);
  /// Whether the edges of its blocks are drawn over the results that are open; of one at most.
  bool isOver(const ComparedRun& run) const { return &run == over_; }
  bool isAnyOver() const { return over_ != nullptr; }
  void setOver(const ComparedRun& run, bool over);
  /// Those that are open, in the order in which they were asked for, whichever was read first.
  const std::vector<std::shared_ptr<ComparedRun>>& runs() const { return runs_; }
  /// What tells a run from the others: "phi20", or "wet/phi20" where there is another phi20.
  QString nameOf(const ComparedRun& run) const;
  /// The same of the results that are open.
  QString nameOfOpen() const;

 signals:
  void changed();      ///< which there are
  void overChanged();  ///< which one's edges are drawn over

 private:
  /// Takes up those that have become open since.
  void update();
  void closeAll();
  std::shared_ptr<ComparedRun> ask(const std::filesystem::path& folder);
  /// Of those that are open first, then of the others.
  std::vector<std::string> names() const;

  Playback& playback_;
  Messages& messages_;
  std::vector<std::shared_ptr<ComparedRun>> asked_, runs_;
  const ComparedRun* over_ = nullptr;  ///< one of those that were asked for
};

}  // namespace talus
