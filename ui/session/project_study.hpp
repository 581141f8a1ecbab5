#pragma once

#include <QObject>
#include <QString>

#include "jobs/study_job.hpp"

namespace talus {

class CurrentProject;
class CurrentRun;
class Messages;

/// The accuracy study of the project that is open, while it is being made: one at a time, whoever asked for it. It ends
/// with the project.
class ProjectStudy : public QObject {
  Q_OBJECT
 public:
  ProjectStudy(CurrentProject& project, CurrentRun& run, Messages& messages);

  bool isBusy() const { return job_.isBusy(); }
  /// The project has a study, of what it was before it was changed.
  bool isOutdated() const;
  const TimeLeft& timeLeft() const { return job_.timeLeft(); }
  /// Empty when a study can be begun; otherwise why not.
  QString whyNot() const;
  void begin();
  /// Runs that have ended are kept.
  void cancel();
  bool isStopping() const { return stopping_; }

  /// Last news of the study: 0…1 and words.
  double fraction() const { return fraction_; }
  const QString& activity() const { return activity_; }

 signals:
  /// Whether it can be begun, whether it is outdated, or how it goes.
  void changed();

 private:
  void takeEnd(const QString& problem);

  CurrentProject& project_;
  CurrentRun& run_;
  Messages& messages_;
  double fraction_ = 0;
  QString activity_;
  bool stopping_ = false;
  StudyJob job_;
};

}  // namespace talus
