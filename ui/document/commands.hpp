#pragma once

#include <QUndoCommand>

#include "document/document.hpp"

namespace talus {

/// Commands hold places and values, never references: the project may be rebuilt around them.
class ChangeMaterial : public QUndoCommand {
 public:
  ChangeMaterial(Document& document, int index, Material changed);
  void redo() override { apply(after_); }
  void undo() override { apply(before_); }

 private:
  void apply(const Material& value);
  Document& document_;
  int index_;
  Material before_, after_;
};

class ChangeJoint : public QUndoCommand {
 public:
  ChangeJoint(Document& document, int index, Joint changed);
  void redo() override { apply(after_); }
  void undo() override { apply(before_); }

 private:
  void apply(const Joint& value);
  Document& document_;
  int index_;
  Joint before_, after_;
};

class ChangeSolid : public QUndoCommand {
 public:
  ChangeSolid(Document& document, int index, Solid changed);
  void redo() override { apply(after_); }
  void undo() override { apply(before_); }

 private:
  void apply(const Solid& value);
  Document& document_;
  int index_;
  Solid before_, after_;
};

class ChangeProject : public QUndoCommand {
 public:
  ChangeProject(Document& document, Project changed, const QString& what);
  void redo() override { apply(after_); }
  void undo() override { apply(before_); }

 private:
  void apply(const Project& value);
  Document& document_;
  Project before_, after_;
};

}  // namespace talus
