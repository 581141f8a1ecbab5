#pragma once

#include <QDialog>

#include "study/accuracy/study_record.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/study/accuracy_chart.hpp"
#include "widgets/study/run_profile.hpp"

class QLabel;
class QLineEdit;
class QPushButton;

namespace talus {

class CurrentProject;
class CurrentRun;
class ProjectStudy;

/// An accuracy study: error against seconds, its runs as a table, the cheapest that meets a target, orders of
/// convergence, where the time of the chosen run went. A run's setting can be given to the project that was studied.
class AccuracyPanel : public QDialog {
  Q_OBJECT
 public:
  AccuracyPanel(CurrentProject& project, CurrentRun& run, ProjectStudy& study, QWidget* parent = nullptr);
  /// The study of the project that is open, and to the front.
  void present();
  /// The study that has this accuracy.json; says a problem in its heading where it cannot be read.
  void load(const std::filesystem::path& file);

 private:
  QWidget* makeHeading();
  QWidget* makeEmpty(ProjectStudy& study);
  QWidget* makeRuns();
  QWidget* makeSide(ProjectStudy& study);
  void askForFile();
  void showProjectsStudy();
  void show(std::optional<StudyRecord> record);
  void showRuns();
  void showOrders();
  void setTarget();
  void tellRecommended();
  void choose(int run);
  void refreshUse();

  CurrentProject& project_;
  CurrentRun& run_;
  std::optional<StudyRecord> record_;
  std::optional<int> chosenRun_;
  QLabel *title_, *note_, *ordersTitle_;
  AccuracyChart* chart_;
  PlainTable *runs_, *orders_;
  QLineEdit* target_;
  QLabel *recommended_, *chosen_;
  QPushButton* use_;
  RunProfile* profile_;
  QWidget *content_, *empty_, *further_;
};

}  // namespace talus
