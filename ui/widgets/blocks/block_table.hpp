#pragma once

#include <QTableView>

#include "session/current_project.hpp"
#include "widgets/blocks/block_rows.hpp"

namespace talus {

/// Blocks as rows: what is selected in it is selected everywhere, and the other way about. The columns are told by
/// whoever has it.
class BlockTable : public QTableView {
  Q_OBJECT
 public:
  explicit BlockTable(CurrentProject& project);
  /// The rows keep their order where there are as many columns as before.
  void setContent(std::vector<BlockColumn> columns);
  void lookFor(const QString& words);
  /// What is said where there is no row.
  void setEmptyWords(const QString& words);
  int shownRows() const { return sorted_.rowCount(); }

 signals:
  /// A row was clicked twice: the view should go there.
  void blockWanted(int block);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void takeSelection();
  void showSelection();

  CurrentProject& project_;
  BlockRows rows_;
  SortedBlocks sorted_;
  QString emptyWords_;
  bool selects_ = false;  ///< the selection that is told of is its own
};

}  // namespace talus
