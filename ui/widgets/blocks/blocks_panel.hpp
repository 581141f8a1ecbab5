#pragma once

#include <QWidget>

class QLineEdit;
class QToolButton;

namespace talus {

class BlockTable;
struct Session;

/// The page of blocks under the view: a table of all of them with what is known of each, a box to look for some, and
/// those that are excavated.
class BlocksPanel : public QWidget {
  Q_OBJECT
 public:
  /// `tools`: buttons beside the box; `menu`: of the right button on a row.
  BlocksPanel(Session& session, const QList<QToolButton*>& tools, const QList<QAction*>& menu);
  /// "Blocks", or that they are those from before the last change.
  QString title() const;

 signals:
  void titleChanged(const QString& title);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  void refreshExcavated();
  void goTo(int block);

  Session& session_;
  BlockTable* table_;
  QLineEdit* words_;
  QToolButton* excavated_;
};

}  // namespace talus
