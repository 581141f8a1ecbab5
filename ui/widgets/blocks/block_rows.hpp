#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <functional>
#include <vector>

namespace talus {

/// What a table of blocks tells in one column.
struct BlockColumn {
  QString title, tip;
  bool isNumber = true;
  /// By which a row is sorted: a number or words; invalid where nothing is known.
  std::function<QVariant(int block)> value;
  std::function<QString(int block)> text;
  std::function<QString(int block)> more{};    ///< a tooltip, where there is more to say
  std::function<bool(int block)> isWarning{};  ///< the cell has a warning sign
};

/// Blocks as rows, whatever is told of them; nothing is kept of a row, so that ten thousand cost no more than ten.
class BlockRows : public QAbstractTableModel {
  Q_OBJECT
 public:
  static constexpr int sort_role = Qt::UserRole;
  using QAbstractTableModel::QAbstractTableModel;
  void setContent(int blocks, std::vector<BlockColumn> columns);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  int blocks_ = 0;
  std::vector<BlockColumn> columns_;
};

/// Rows whose words hold what is looked for, sorted: numbers as numbers, "slope.10" after "slope.2", nothing last.
class SortedBlocks : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit SortedBlocks(QObject* parent = nullptr);
  void lookFor(const QString& words);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  QString words_;
};

/// Whether one name stands before another: runs of digits count as numbers.
bool isNaturallyBefore(QStringView a, QStringView b);

}  // namespace talus
