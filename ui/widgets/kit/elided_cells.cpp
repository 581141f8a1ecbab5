#include "widgets/kit/elided_cells.hpp"

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QToolTip>

namespace talus {

bool ElidedCells::helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                            const QModelIndex& index) {
  const bool isCut = sizeHint(option, index).width() > view->visualRect(index).width();
  if (event->type() != QEvent::ToolTip || !isCut || index.data(Qt::ToolTipRole).isValid())
    return QStyledItemDelegate::helpEvent(event, view, option, index);
  QToolTip::showText(event->globalPos(), index.data().toString(), view);
  return true;
}

}  // namespace talus
