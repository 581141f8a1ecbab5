#pragma once

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "widgets/workspace.hpp"

namespace talus {

/// From draft to reference: the settings of the project's accuracy study that are best for their cost, the cheapest
/// first. Each says what it took and how far off it was, and can be given to the project. Without a study it says how
/// to get one.
class AccuracySlider : public QWidget {
  Q_OBJECT
 public:
  explicit AccuracySlider(Workspace& workspace);

 private:
  void refresh();
  void tell();
  void say(const QString& figures, const QString& words);
  std::size_t position() const { return static_cast<std::size_t>(slider_->value()); }
  const AccuracyRow& row(int run) const;

  Workspace& workspace_;
  QSlider* slider_;
  QLabel *figures_, *words_;
  QPushButton* use_;
  std::vector<int> best_;   ///< runs of the study, a place of the slider each; empty: nothing to choose from
  std::optional<int> has_;  ///< the run whose setting the project has
};

}  // namespace talus
