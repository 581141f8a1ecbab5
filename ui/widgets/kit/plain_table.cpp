#include "widgets/kit/plain_table.hpp"

#include <QHeaderView>
#include <QScrollBar>
#include <algorithm>

#include "widgets/kit/elided_cells.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

namespace {
constexpr int cell_padding = 28;  // beside a cell's words: the style sheet's, the focus frame, and what wrapping rounds
constexpr int line_gap = 10;
constexpr int rows_measured = 100;  // for the width of a column that fits its words
}  // namespace

PlainTable::PlainTable() {
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(theme::now().metrics.row);
  verticalHeader()->setMinimumSectionSize(20);
  setShowGrid(false);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setTextElideMode(Qt::ElideRight);
  setWordWrap(false);  // words would elide where a line breaks, with room left
  setItemDelegate(new ElidedCells(this));
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  horizontalHeader()->setResizeContentsPrecision(rows_measured);
}

void PlainTable::setContent(const QStringList& heads, const std::vector<QStringList>& rows,
                            const std::vector<bool>& words) {
  clear();
  setRowCount(static_cast<int>(rows.size()));
  setColumnCount(static_cast<int>(heads.size()));
  setHorizontalHeaderLabels(heads);
  for (int column = 0; column < columnCount(); ++column) {
    const auto alignment = (words[static_cast<size_t>(column)] ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter;
    horizontalHeaderItem(column)->setTextAlignment(alignment);
    for (int row = 0; row < rowCount(); ++row) {
      auto* cell = new QTableWidgetItem(rows[static_cast<size_t>(row)].value(column));
      cell->setTextAlignment(alignment);
      setItem(row, column, cell);
    }
  }
}

void PlainTable::wrapWords(int most) {
  setWordWrap(true);
  connect(horizontalHeader(), &QHeaderView::sectionResized, this, [this, most](int column, int, int width) {
    if (column != 0) return;
    const QRect room(0, 0, width - cell_padding, QWIDGETSIZE_MAX);
    for (int row = 0; row < rowCount(); ++row) {
      const QRect words = fontMetrics().boundingRect(room, Qt::TextWordWrap, item(row, 0)->text());
      setRowHeight(row, std::max(verticalHeader()->defaultSectionSize(), words.height() + line_gap));
    }
    fitHeight(most);
  });
}

void PlainTable::fitHeight(int most) {
  int height = horizontalHeader()->sizeHint().height();
  if (horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) height += horizontalScrollBar()->sizeHint().height();
  for (int row = 0; row < std::min(rowCount(), most); ++row) height += rowHeight(row);
  setFixedHeight(height);
  setSizePolicy(sizePolicy().horizontalPolicy(), QSizePolicy::Fixed);  // or its section takes room that it leaves
}

}  // namespace talus
