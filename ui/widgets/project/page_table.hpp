#pragma once

#include <vector>

#include "document/selection.hpp"
#include "session/workflow_page.hpp"
#include "widgets/kit/plain_table.hpp"

namespace talus {

class CurrentProject;
class Display;
class Playback;
struct Project;

/// What the project holds of one page of the workflow, as rows; a row is the thing that it selects.
struct PageRows {
  struct Row {
    Item item;
    QStringList cells;
    QStringList places{};  ///< of the project file, a cell: what a double click lets be typed; empty: nothing
  };
  QString title;
  QStringList heads;
  int wordColumns = 1;  ///< columns from the left that hold words; the others hold numbers
  std::vector<Row> rows;
  QString empty;          ///< what to say when there is no row
  int roomy = -1;         ///< a column that takes the room which the others leave; none: all share it
  bool sortable = false;  ///< by a click on a head; else the order says something
};

/// For the pages that set the project up, but for those of blocks and mesh, which have tables of their own.
PageRows rowsOf(WorkflowPage page, const Project& project);

/// The table under the view: what the project holds of the page that is open; from a run on, how its blocks move.
class PageTable : public PlainTable {
  Q_OBJECT
 public:
  PageTable(CurrentProject& project, Playback& playback, Display& display);
  const QString& title() const { return content_.title; }

 signals:
  void titleChanged(const QString& title);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  bool mayShowMotion() const;
  void showSelection();
  void sortBy(int column);
  void sortRows();
  void editCell(int row, int column);
  CurrentProject& project_;
  Playback& playback_;
  Display& display_;
  PageRows content_;
  bool showsMotion_ = false;
  int sortedBy_ = -1;  ///< column; −1: as the project has them
  Qt::SortOrder order_ = Qt::AscendingOrder;
};

}  // namespace talus
