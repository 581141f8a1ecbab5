#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/accuracy_chart.hpp"
#include "widgets/plain_table.hpp"
#include "widgets/run_profile.hpp"
#include "widgets/workspace.hpp"

namespace talus {

/// An accuracy study: error against seconds, its runs as a table, the cheapest that meets a target, orders of
/// convergence, where the time of the chosen run went. A run's setting can be given to the project that was studied.
class AccuracyPanel : public QDialog {
  Q_OBJECT
 public:
  explicit AccuracyPanel(Workspace& workspace, QWidget* parent = nullptr);
  /// The study of the project that is open, and to the front.
  void present();
  /// The study that has this accuracy.json; says a problem in its heading where it cannot be read.
  void load(const std::filesystem::path& file);

 private:
  QWidget* makeHeading();
  QWidget* makeRuns();
  QWidget* makeSide();
  void askForFile();
  void show(std::optional<StudyRecord> record);
  void showRuns();
  void showOrders();
  void setTarget();
  void tellRecommended();
  void choose(int run);
  void refreshUse();

  Workspace& workspace_;
  std::optional<StudyRecord> record_;
  std::optional<int> run_;
  QLabel *title_, *note_, *empty_, *ordersTitle_;
  AccuracyChart* chart_;
  PlainTable *runs_, *orders_;
  QLineEdit* target_;
  QLabel *recommended_, *chosen_;
  QPushButton* use_;
  RunProfile* profile_;
  QWidget* content_;
};

}  // namespace talus
