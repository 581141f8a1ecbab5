#include "session/picking.hpp"

#include <utility>

namespace talus {

void Picking::ask(const QString& prompt, int count, Done done) {
  prompt_ = prompt;
  wanted_ = count;
  places_.clear();
  done_ = std::move(done);
  emit changed();
}

void Picking::take(const PickedPlace& place) {
  if (!isAsking()) return;
  places_.push_back(place);
  if (static_cast<int>(places_.size()) < wanted_) {
    emit changed();
    return;
  }
  // Whoever asked may ask for more at once.
  const auto places = std::exchange(places_, {});
  const Done done = std::exchange(done_, {});
  cancel();
  done(places);
}

void Picking::cancel() {
  wanted_ = 0;
  prompt_.clear();
  places_.clear();
  done_ = {};
  emit changed();
}

}  // namespace talus
