#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "jobs/study_job.hpp"

namespace talus {

class CurrentProject;
class CurrentRun;
class Messages;

/// What a study is asked for.
struct StudyWish {
  std::optional<StudyMeasure> measure{};  ///< empty: what the project expects, else displacements
  int repeats = 1;                        ///< runs of each setting
  bool operator==(const StudyWish&) const = default;
};

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
  /// The project, as it is, has a study.
  bool isCurrent() const;
  /// All runs of the study have ended.
  bool isComplete() const;
  /// As the project's study was made; where there is none as studies usually are.
  StudyWish wish() const;
  /// Empty when such a study can be begun, or gone on with; otherwise why not.
  QString whyNot(const StudyWish& wish) const;
  void begin(const StudyWish& wish);
  /// Runs that have ended are kept.
  void cancel();
  bool isStopping() const { return stopping_; }

  /// Last news of the study: 0…1 and words.
  double fraction() const { return fraction_; }
  const QString& activity() const { return activity_; }

 signals:
  /// Whether it can be begun, whether it is outdated, or how it goes.
  void changed();
  /// The project has another study, or is another one: wish() is another, too.
  void madeAnother();

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
