#pragma once

#include <vector>

#include "widgets/plain_table.hpp"
#include "widgets/workspace.hpp"

namespace talus {

/// The project's content of one step as rows; a row is the thing that it selects.
struct StepRows {
  struct Row {
    Item item;
    QStringList cells;
  };
  QString title;
  QStringList heads;
  int wordColumns = 1;  ///< columns from the left that hold words; the others hold numbers
  std::vector<Row> rows;
  QString empty;  ///< what to say when there is no row
};

/// For the steps that set the project up.
StepRows rowsOf(Step step, const Project& project, const BlockSystem* system);

/// The table under the view: what the project holds in the step that is open; from a run on, how its blocks move.
class StepTable : public PlainTable {
  Q_OBJECT
 public:
  explicit StepTable(Workspace& workspace);

 signals:
  void titleChanged(const QString& title);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  bool mayShowMotion() const;
  void showSelection();
  Workspace& workspace_;
  StepRows content_;
  bool showsMotion_ = false;
};

}  // namespace talus
