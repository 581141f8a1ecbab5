#pragma once

#include <QWidget>

#include "session/project_study.hpp"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace talus {

class NumberField;

/// Begins the accuracy study of the project, goes on with it, says how it goes and stops it.
class StudyStart : public QWidget {
  Q_OBJECT
 public:
  /// `asks`: what errors are of and how often each setting is run is asked for; else it is as it was before.
  StudyStart(ProjectStudy& study, bool asks);

 private:
  void addQuestions(QLayout& column);
  void takeWish();
  void takeRepeats(double repeats);
  void tell();
  void tellHowItGoes();

  ProjectStudy& study_;
  StudyWish wish_;
  QLabel* words_;
  QWidget* questions_;
  QComboBox* measure_;
  NumberField* repeats_;
  QPushButton* button_;
  QProgressBar* bar_;
};

}  // namespace talus
