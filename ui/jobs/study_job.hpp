#pragma once

#include <QObject>
#include <QString>

#include "jobs/background_job.hpp"
#include "study/accuracy/study_plan.hpp"

namespace talus {

/// Makes the accuracy study of a project beside its file: runs are processes of talus-cli, on the cores that are free.
class StudyJob : public QObject {
  Q_OBJECT
 public:
  explicit StudyJob(QObject* parent = nullptr);

  bool isBusy() const { return work_.isBusy(); }
  const TimeLeft& timeLeft() const { return work_.timeLeft(); }
  /// Goes on with a study that was stopped; another one's place, of the project before it was changed, is taken.
  void begin(const StudyRequest& request);
  /// Runs that have ended are kept.
  void cancel() { work_.cancel(); }

 signals:
  void progressed(double fraction, const QString& what);
  /// `problem` is empty where all went well, or it was cancelled.
  void ended(const QString& problem);

 private:
  QString problem_;
  BackgroundJob work_;  ///< last: its thread ends before the others go
};

/// talus-cli: at the path in TALUS_CLI, else beside the running program.
std::filesystem::path command_line_program();

}  // namespace talus
