#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>

#include "jobs/results_loader.hpp"

namespace talus {

class Messages;
class Playback;

/// Other results that are looked at beside those that are open, at the same moment: the frame nearest to it.
class ComparedResults : public QObject {
  Q_OBJECT
 public:
  ComparedResults(Playback& playback, Messages& messages);

  /// What cannot be read is said as a problem.
  void open(const std::filesystem::path& folder);
  void close();
  /// Null while nothing is compared.
  const std::shared_ptr<const ResultsIndex>& results() const { return index_; }
  /// Null until it has been read.
  const std::shared_ptr<const Frame>& frame() const { return frame_; }
  /// Of the folder: "phi20".
  QString name() const;

 signals:
  void changed();  ///< other results, or none
  void frameChanged();

 private:
  void follow();

  Playback& playback_;
  std::shared_ptr<const ResultsIndex> index_;
  std::shared_ptr<const Frame> frame_;
  ResultsLoader loader_;
};

}  // namespace talus
