#pragma once

#include <QTreeWidget>
#include <map>
#include <vector>

#include "document/selection.hpp"
#include "session/workflow_page.hpp"

class QMenu;

namespace talus {

class CurrentProject;
class Display;
class Messages;

/// All of the project, each group under its page of the workflow, with its telling figure at the right.
class ProjectTree : public QTreeWidget {
  Q_OBJECT
 public:
  ProjectTree(CurrentProject& project, Display& display, Messages& messages);

  /// The row of a thing, null when the project does not hold it.
  QTreeWidgetItem* rowOf(const Item& item) const;
  /// Another choice behind the plus of a page's group than one of the schema's things.
  void setNewMenu(WorkflowPage page, QMenu* menu);
  /// Puts the keyboard on the plus that makes a thing of this list of the project; false where there is none.
  bool focusNew(const QString& list);

 signals:
  /// Of what is selected, at a point of the screen.
  void menuWanted(const QPoint& at);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void rebuild();
  void unfoldPage();
  void showSelection();
  QTreeWidgetItem* addGroup(WorkflowPage page, const QString& figure);
  QTreeWidgetItem* addRow(QTreeWidgetItem* group, const Item& item, const QString& name, const QString& figure);
  /// A button at the group that makes a thing of one of these kinds.
  void offerNew(WorkflowPage page, const std::vector<Item::Kind>& kinds);
  void addJoints(QTreeWidgetItem* group);
  void addBlocks(QTreeWidgetItem* group);
  void addLoads(QTreeWidgetItem* group);

  CurrentProject& project_;
  Display& display_;
  Messages& messages_;
  std::map<WorkflowPage, QTreeWidgetItem*> groups_;
  std::vector<QTreeWidgetItem*> blockRows_;  ///< of the first blocks, as many as are listed
  std::map<WorkflowPage, QMenu*> newMenus_;
};

}  // namespace talus
