#pragma once

#include <QTreeWidget>
#include <map>

#include "widgets/workspace.hpp"

namespace talus {

/// All of the project, each group under its step, with its telling figure at the right.
class ProjectTree : public QTreeWidget {
  Q_OBJECT
 public:
  explicit ProjectTree(Workspace& workspace);

  /// The row of a thing, null when the project does not hold it.
  QTreeWidgetItem* rowOf(const Item& item) const;

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void rebuild();
  void unfoldStep();
  void showSelection();
  QTreeWidgetItem* addGroup(Step step, const QString& figure);
  QTreeWidgetItem* addRow(QTreeWidgetItem* group, const Item& item, const QString& name, const QString& figure);
  void addJoints(QTreeWidgetItem* group);
  void addBlocks(QTreeWidgetItem* group);
  void addLoads(QTreeWidgetItem* group);

  Workspace& workspace_;
  std::map<Step, QTreeWidgetItem*> groups_;
};

}  // namespace talus
