#pragma once

#include <QStyledItemDelegate>

namespace talus {

/// Cells whose words do not fit are told whole by their tooltip, where they have none of their own.
class ElidedCells : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                 const QModelIndex& index) override;
};

}  // namespace talus
