#pragma once

#include <QWidget>

class QLineEdit;
class QToolButton;

namespace talus {

class BlockSurvey;
class BlockTable;
class CurrentProject;
class Messages;

/// The page of blocks under the view: a table of all of them with what is known of each, a box to look for some, and
/// those that are excavated.
class BlocksPanel : public QWidget {
  Q_OBJECT
 public:
  /// `tools`: buttons beside the box.
  BlocksPanel(CurrentProject& project, BlockSurvey& survey, Messages& messages, const QList<QToolButton*>& tools);
  /// "Blocks", or that they are those from before the last change.
  QString title() const;

 signals:
  void titleChanged(const QString& title);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  void refreshExcavated();

  CurrentProject& project_;
  BlockSurvey& survey_;
  Messages& messages_;
  BlockTable* table_;
  QLineEdit* words_;
  QToolButton* excavated_;
};

}  // namespace talus
