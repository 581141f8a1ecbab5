#include "widgets/kit/fitted_columns.hpp"

#include <QEvent>
#include <QHeaderView>
#include <QTableView>
#include <algorithm>
#include <numeric>
#include <vector>

namespace talus {

FittedColumns::FittedColumns(QTableView& table) : QObject(&table), table_(table) {
  table_.horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_.viewport()->installEventFilter(this);
  connect(table_.model(), &QAbstractItemModel::dataChanged, this, &FittedColumns::fit);
}

bool FittedColumns::isWiderThanItsPlace() const {
  return table_.horizontalHeader()->length() > table_.viewport()->width();
}

bool FittedColumns::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) fit();
  return QObject::eventFilter(watched, event);
}

void FittedColumns::fit() {
  QHeaderView& head = *table_.horizontalHeader();
  const QAbstractItemView& cells = table_;
  std::vector<int> widths;
  for (int column = 0; column < head.count(); ++column)
    widths.push_back(std::max(cells.sizeHintForColumn(column), head.sectionSizeHint(column)));
  int left = std::max(0, table_.viewport()->width() - std::accumulate(widths.begin(), widths.end(), 0));
  for (int column = 0; column < head.count(); ++column) {
    const int share = left / (head.count() - column);
    left -= share;
    head.resizeSection(column, widths[static_cast<std::size_t>(column)] + share);
  }
  emit fitted();
}

}  // namespace talus
