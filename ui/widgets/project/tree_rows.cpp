#include "widgets/project/tree_rows.hpp"

#include <QApplication>
#include <QPainter>
#include <algorithm>

namespace talus {

namespace {
constexpr int gap = 8, edge = 4;  // pixels: between name and figure, at the right end
}

void TreeRows::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const QModelIndex beside = index.siblingAtColumn(figure_column);
  const QFont font = beside.data(Qt::FontRole).value<QFont>();
  QStyleOptionViewItem row(option);
  initStyleOption(&row, index);
  const QStyle& style = row.widget ? *row.widget->style() : *QApplication::style();
  const QRect words = style.subElementRect(QStyle::SE_ItemViewItemText, &row, row.widget);
  // A name comes before its figure, which may be a sentence.
  const QFontMetrics names(row.font), figures(font);
  const int own = std::min(names.horizontalAdvance(row.text), words.width() * 3 / 5);
  const QString figure = figures.elidedText(beside.data().toString(), Qt::ElideRight, words.width() - own - gap - edge);
  const int room = figure.isEmpty() ? 0 : figures.horizontalAdvance(figure) + gap + edge;
  row.text = names.elidedText(row.text, Qt::ElideRight, words.width() - room);
  style.drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);
  if (figure.isEmpty()) return;
  painter->save();
  painter->setFont(font);
  painter->setPen(beside.data(Qt::ForegroundRole).value<QBrush>().color());
  painter->drawText(option.rect.adjusted(0, 0, -edge, 0), Qt::AlignRight | Qt::AlignVCenter, figure);
  painter->restore();
}

}  // namespace talus
