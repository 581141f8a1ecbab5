#pragma once

#include <QSlider>
#include <QWidget>

#include "study/accuracy/study_record.hpp"

class QLabel;
class QPushButton;

namespace talus {

class CurrentProject;
class CurrentRun;
class ProjectStudy;
class StudyStart;

/// From draft to reference: the settings of the project's accuracy study that are best for their cost, the cheapest
/// first. Each says what it took and how far off it was, and can be given to the project. Where no study is of the
/// project as it is, one can be made here.
class AccuracySlider : public QWidget {
  Q_OBJECT
 public:
  AccuracySlider(CurrentProject& project, CurrentRun& run, ProjectStudy& study);

 private:
  void refresh();
  void tell();
  void offerStudy();
  std::size_t position() const { return static_cast<std::size_t>(slider_->value()); }
  const AccuracyRow& row(int run) const;

  CurrentProject& project_;
  CurrentRun& run_;
  ProjectStudy& study_;
  QSlider* slider_;
  QLabel *figures_, *words_;
  QPushButton* use_;
  StudyStart* start_;
  std::vector<int> best_;   ///< runs of the study, a place of the slider each; empty: nothing to choose from
  std::optional<int> has_;  ///< the run whose setting the project has
};

}  // namespace talus
