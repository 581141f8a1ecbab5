#include "widgets/plain_table.hpp"

#include <QHeaderView>
#include <algorithm>

#include "widgets/theme.hpp"

namespace talus {

PlainTable::PlainTable() {
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(theme::now().metrics.row);
  verticalHeader()->setMinimumSectionSize(20);
  setShowGrid(false);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setTextElideMode(Qt::ElideRight);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
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

void PlainTable::fitHeight(int most) {
  const int rows = std::min(rowCount(), most);
  setFixedHeight(horizontalHeader()->sizeHint().height() + rows * verticalHeader()->defaultSectionSize() + 2);
}

}  // namespace talus
