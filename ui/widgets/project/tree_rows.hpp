#pragma once

#include <QStyledItemDelegate>

namespace talus {

/// Rows of the tree: a name, and at the right end its figure (the text of `figure_column`, which is hidden). A name
/// elides only where the row's own figure needs the room.
class TreeRows : public QStyledItemDelegate {
  Q_OBJECT
 public:
  static constexpr int figure_column = 1;
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace talus
