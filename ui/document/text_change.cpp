#include "document/text_change.hpp"

#include <algorithm>

namespace talus {

TextChange::TextChange(Document& document, std::unique_ptr<Document::Content> changed, const QString& what, int gesture)
    : QUndoCommand(what), document_(document), changed_(std::move(changed)), gesture_(gesture) {
  keepDifference(document.text(), changed_->text);
}

void TextChange::keepDifference(const std::string& before, const std::string& after) {
  const auto first = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  const std::size_t front = static_cast<std::size_t>(first.first - before.begin());
  const std::size_t most = std::min(before.size(), after.size()) - front;
  std::size_t back = 0;
  while (back < most && before[before.size() - 1 - back] == after[after.size() - 1 - back]) ++back;
  at_ = front;
  before_ = before.substr(front, before.size() - back - front);
  after_ = after.substr(front, after.size() - back - front);
}

void TextChange::redo() {
  if (changed_) return document_.put(std::move(changed_));
  std::string text = document_.text();
  document_.put(Document::read(text.replace(at_, before_.size(), after_)));
}

void TextChange::undo() { document_.put(Document::read(undone(document_.text()))); }

bool TextChange::mergeWith(const QUndoCommand* next) {
  const std::string now = document_.text();  // the next one is done by then
  keepDifference(undone(static_cast<const TextChange*>(next)->undone(now)), now);
  setObsolete(before_ == after_);
  return true;
}

}  // namespace talus
