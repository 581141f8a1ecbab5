#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace talus {

class ProjectStudy;

/// Begins the accuracy study of the project, says how it goes and stops it.
class StudyStart : public QWidget {
  Q_OBJECT
 public:
  explicit StudyStart(ProjectStudy& study);

 private:
  void tell();
  void tellHowItGoes();

  ProjectStudy& study_;
  QLabel* words_;
  QPushButton* button_;
  QProgressBar* bar_;
};

}  // namespace talus
