#include "document/autosave.hpp"

#include <cstdlib>
#include <utility>

#include "base/error.hpp"

namespace talus {

namespace {

/// Characters of the project's text: a solid, a joint set, a table that was pasted.
constexpr long large_change = 200;

}  // namespace

Autosave::Autosave(Document& document, int interval_ms) : document_(document) {
  timer_.setSingleShot(true);
  timer_.setInterval(interval_ms);
  connect(&timer_, &QTimer::timeout, this, &Autosave::keep);
  connect(&document_, &Document::opened, this, [this] {
    safe_.clear();
    slot_.clear();
  });
  connect(&document_, &Document::savedChanged, this, &Autosave::follow);
  // Not projectChanged: it comes before the stack knows whether this is what was saved.
  connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &Autosave::follow);
}

void Autosave::follow() {
  if (document_.isSaved()) {
    timer_.stop();
    slot_.clear();
    safe_ = document_.text();
    return;
  }
  if (document_.text() == safe_) return;
  const long grown = static_cast<long>(document_.text().size()) - static_cast<long>(safe_.size());
  if (safe_.empty() || std::abs(grown) >= large_change)
    keep();
  else if (!timer_.isActive())
    timer_.start();
}

void Autosave::keep() {
  timer_.stop();
  try {
    slot_.keep(document_.draft(), document_.name());
    safe_ = document_.text();
    failing_ = false;
  } catch (const InputError& error) {
    if (!std::exchange(failing_, true)) emit failed(error);
  }
}

}  // namespace talus
