#pragma once

#include <QUndoCommand>
#include <memory>
#include <string>

#include "document/content.hpp"

namespace talus {

/// What stood at a place of the project's text, and what stands there now: the one command of the undo stack. It keeps
/// a place and values, never references: the project is read anew around it.
class TextChange : public QUndoCommand {
 public:
  TextChange(Document& document, std::unique_ptr<Document::Content> changed, const QString& what, int gesture);

  int id() const override { return gesture_; }
  void redo() override;
  void undo() override;
  /// Takes a change in that follows in the same gesture.
  bool mergeWith(const QUndoCommand* next) override;

 private:
  void keepDifference(const std::string& before, const std::string& after);
  std::string undone(std::string text) const { return text.replace(at_, after_.size(), before_); }

  Document& document_;
  std::unique_ptr<Document::Content> changed_;  ///< until it is done for the first time: it has been read already
  int gesture_;
  std::size_t at_ = 0;
  std::string before_, after_;
};

}  // namespace talus
