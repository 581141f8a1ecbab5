#pragma once

#include <QAction>
#include <QObject>
#include <vector>

namespace talus {

class RuleDialog;
struct Session;

/// Which blocks are selected, beside by clicks, and what is done to those that are.
class BlockActions : public QObject {
  Q_OBJECT
 public:
  BlockActions(Session& session, QWidget& window);

  QAction *byRule, *everyOne, *others, *neighbours;
  /// Shift and drag draw a lasso in the view while it is checked.
  QAction* lasso;
  QAction *excavate, *merge;
  std::vector<QAction*> all() const { return {byRule, everyOne, others, neighbours, lasso, excavate, merge}; }
  /// Why one of them cannot be used now; empty when it can.
  QString whyNot(const QAction* action) const;

 private:
  QAction* add(const QString& words, const QString& icon, const QKeySequence& key, void (BlockActions::*act)());
  void showRule();
  void selectAll();
  void selectOthers();
  void selectNeighbours();
  void excavateSelected();
  void mergeSelected();
  int count() const;

  Session& session_;
  QWidget& window_;
  RuleDialog* rule_ = nullptr;  ///< once it has been asked for
};

}  // namespace talus
