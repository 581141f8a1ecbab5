#pragma once

#include <QObject>

class QTableView;

namespace talus {

/// Columns of a table that share its room, none narrower than its widest cell and its title: of a number no digit is
/// left out. What has no room then is scrolled to.
class FittedColumns : public QObject {
  Q_OBJECT
 public:
  explicit FittedColumns(QTableView& table);
  /// Some of it has to be scrolled to.
  bool isWiderThanItsPlace() const;

 signals:
  /// They were given other widths.
  void fitted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();

  QTableView& table_;
};

}  // namespace talus
