#pragma once

#include <QUndoCommand>
#include <utility>
#include <vector>

#include "document/document.hpp"

namespace talus {

// Commands hold places and values, never references: the project may be rebuilt around them.

/// An item of one of the project's lists, a joint among its joints, gets other values. `what` says it in the undo list.
template <class Thing>
class ChangeItem : public QUndoCommand {
 public:
  ChangeItem(Document& document, std::vector<Thing> Project::*list, int index, Thing changed, const QString& what)
      : QUndoCommand(what),
        document_(document),
        list_(list),
        index_(static_cast<std::size_t>(index)),
        before_((document.project().*list).at(index_)),
        after_(std::move(changed)) {}
  void redo() override { apply(after_); }
  void undo() override { apply(before_); }

 private:
  void apply(const Thing& value) {
    (document_.project_.*list_)[index_] = value;
    emit document_.projectChanged();
  }

  Document& document_;
  std::vector<Thing> Project::*list_;
  std::size_t index_;
  Thing before_, after_;
};

/// The whole project gets other values.
class ChangeProject : public QUndoCommand {
 public:
  ChangeProject(Document& document, Project changed, const QString& what)
      : QUndoCommand(what), document_(document), before_(document.project()), after_(std::move(changed)) {}
  void redo() override { apply(after_); }
  void undo() override { apply(before_); }

 private:
  void apply(const Project& value) {
    document_.project_ = value;
    emit document_.projectChanged();
  }

  Document& document_;
  Project before_, after_;
};

}  // namespace talus
