#include "widgets/blocks/block_table.hpp"

#include <QHeaderView>
#include <QPainter>
#include <QScopedValueRollback>
#include <algorithm>

#include "widgets/kit/elided_cells.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

namespace {

constexpr int widest_column = 180;
constexpr int rows_measured = 100;

}  // namespace

BlockTable::BlockTable(CurrentProject& project) : project_(project) {
  sorted_.setSourceModel(&rows_);
  setModel(&sorted_);
  setSortingEnabled(true);
  sortByColumn(0, Qt::AscendingOrder);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(theme::now().metrics.row);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);  // none of ten thousand rows is measured
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setStretchLastSection(true);
  horizontalHeader()->setResizeContentsPrecision(rows_measured);
  setShowGrid(false);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setTextElideMode(Qt::ElideRight);
  setItemDelegate(new ElidedCells(this));
  setWordWrap(false);
  setMouseTracking(true);
  setTabKeyNavigation(false);
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &BlockTable::takeSelection);
  connect(&project_.selection(), &Selection::changed, this, [this] {
    if (!selects_) showSelection();
  });
  connect(this, &QTableView::doubleClicked, this,
          [this](const QModelIndex& index) { emit blockWanted(sorted_.mapToSource(index).row()); });
  connect(this, &QTableView::entered, this,
          [this](const QModelIndex& index) { project_.selection().hoverBlock(sorted_.mapToSource(index).row()); });
}

void BlockTable::setContent(std::vector<BlockColumn> columns) {
  const QScopedValueRollback silent(selects_, true);
  const int blocks = project_.system() ? static_cast<int>(project_.system()->blocks.size()) : 0;
  const bool isNew = rows_.columnCount() != static_cast<int>(columns.size());
  rows_.setContent(blocks, std::move(columns));
  if (isNew) sortByColumn(0, Qt::AscendingOrder);
  for (int column = 0; column < rows_.columnCount(); ++column) {
    const int head = horizontalHeader()->sectionSizeHint(column);
    setColumnWidth(column, std::min(std::max(sizeHintForColumn(column), head), widest_column));
  }
  showSelection();
}

void BlockTable::lookFor(const QString& words) {
  {
    const QScopedValueRollback silent(selects_, true);  // rows that go are not taken out of the selection
    sorted_.lookFor(words);
  }
  showSelection();
}

void BlockTable::setEmptyWords(const QString& words) {
  emptyWords_ = words;
  viewport()->update();
}

void BlockTable::takeSelection() {
  if (selects_) return;
  const QScopedValueRollback own(selects_, true);
  std::vector<int> blocks;
  for (const QItemSelectionRange& range : selectionModel()->selection())
    for (int row = range.top(); row <= range.bottom(); ++row)
      blocks.push_back(sorted_.mapToSource(sorted_.index(row, 0)).row());
  project_.selection().selectBlocks(std::move(blocks));
}

void BlockTable::showSelection() {
  const QScopedValueRollback silent(selects_, true);
  std::vector<int> rows;
  for (const int block : project_.selection().blocks())
    if (const QModelIndex index = sorted_.mapFromSource(rows_.index(block, 0)); index.isValid())
      rows.push_back(index.row());
  std::sort(rows.begin(), rows.end());
  QItemSelection selection;
  for (std::size_t first = 0, next = 0; first < rows.size(); first = next) {
    while (next < rows.size() && rows[next] - rows[first] == static_cast<int>(next - first)) ++next;
    selection.select(sorted_.index(rows[first], 0), sorted_.index(rows[next - 1], sorted_.columnCount() - 1));
  }
  selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
  if (!rows.empty()) scrollTo(sorted_.index(rows.front(), 0));
}

void BlockTable::paintEvent(QPaintEvent* event) {
  QTableView::paintEvent(event);
  if (sorted_.rowCount() > 0) return;
  QPainter painter(viewport());
  painter.setPen(theme::colours().textMuted);
  painter.drawText(viewport()->rect(), Qt::AlignCenter, emptyWords_);
}

void BlockTable::leaveEvent(QEvent* event) {
  project_.selection().hoverBlock(std::nullopt);
  QTableView::leaveEvent(event);
}

}  // namespace talus
