#include "widgets/blocks/block_rows.hpp"

#include "widgets/kit/theme.hpp"

namespace talus {

void BlockRows::setContent(int blocks, std::vector<BlockColumn> columns) {
  beginResetModel();
  blocks_ = blocks;
  columns_ = std::move(columns);
  endResetModel();
}

int BlockRows::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : blocks_; }

int BlockRows::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

QVariant BlockRows::data(const QModelIndex& index, int role) const {
  const BlockColumn& column = columns_[static_cast<std::size_t>(index.column())];
  switch (role) {
    case Qt::DisplayRole:
      return column.text(index.row());
    case sort_role:
      return column.value(index.row());
    case Qt::ToolTipRole:
      return column.more ? QVariant(column.more(index.row())) : QVariant();
    case Qt::DecorationRole:
      return column.isWarning && column.isWarning(index.row())
                 ? QVariant(theme::icon(QStringLiteral("warning"), theme::Tone::warn))
                 : QVariant();
    case Qt::TextAlignmentRole:
      return QVariant((column.isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant BlockRows::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const BlockColumn& column = columns_[static_cast<std::size_t>(section)];
  if (role == Qt::DisplayRole) return column.title;
  if (role == Qt::ToolTipRole) return column.tip;
  if (role == Qt::TextAlignmentRole)
    return QVariant((column.isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  return {};
}

SortedBlocks::SortedBlocks(QObject* parent) : QSortFilterProxyModel(parent) { setSortRole(BlockRows::sort_role); }

void SortedBlocks::lookFor(const QString& words) {
  words_ = words.trimmed();
  invalidateFilter();
}

bool SortedBlocks::filterAcceptsRow(int row, const QModelIndex& parent) const {
  if (words_.isEmpty()) return true;
  for (int column = 0; column < sourceModel()->columnCount(parent); ++column) {
    const QVariant value = sourceModel()->index(row, column, parent).data(BlockRows::sort_role);
    if (value.typeId() == QMetaType::QString && value.toString().contains(words_, Qt::CaseInsensitive)) return true;
  }
  return false;
}

bool SortedBlocks::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const QVariant a = left.data(BlockRows::sort_role), b = right.data(BlockRows::sort_role);
  // What is not known stands last, whichever way the others go.
  if (!a.isValid() || !b.isValid()) return sortOrder() == Qt::AscendingOrder ? a.isValid() : b.isValid();
  if (a.typeId() == QMetaType::QString) return isNaturallyBefore(a.toString(), b.toString());
  return a.toDouble() < b.toDouble();
}

bool isNaturallyBefore(QStringView a, QStringView b) {
  const auto digitsFrom = [](QStringView text, qsizetype start) {
    qsizetype end = start;
    while (end < text.size() && text[end].isDigit()) ++end;
    return end;
  };
  qsizetype i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (a[i].isDigit() && b[k].isDigit()) {
      const qsizetype endA = digitsFrom(a, i), endB = digitsFrom(b, k);
      const auto numberA = a.sliced(i, endA - i).toULongLong(), numberB = b.sliced(k, endB - k).toULongLong();
      if (numberA != numberB) return numberA < numberB;
      i = endA;
      k = endB;
    } else {
      const QChar letterA = a[i++].toCaseFolded(), letterB = b[k++].toCaseFolded();
      if (letterA != letterB) return letterA < letterB;
    }
  }
  return a.size() - i < b.size() - k;
}

}  // namespace talus
