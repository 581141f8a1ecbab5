#include "session/compared_results.hpp"

#include "session/messages.hpp"
#include "session/playback.hpp"

namespace talus {

ComparedResults::ComparedResults(Playback& playback, Messages& messages) : playback_(playback) {
  connect(&loader_, &ResultsLoader::opened, this, [this](const auto& index) {
    index_ = index;
    emit changed();
    follow();
  });
  connect(&loader_, &ResultsLoader::frameReady, this, [this](const auto& frame) {
    frame_ = frame;
    emit frameChanged();
  });
  connect(&loader_, &ResultsLoader::failed, this,
          [&messages](const InputError& error) { messages.add(problemOf(error, Problem::Of::results)); });
  connect(&playback, &Playback::frameChanged, this, &ComparedResults::follow);
  connect(&playback, &Playback::framesChanged, this, [this] {
    if (playback_.times().empty()) close();
  });
}

void ComparedResults::open(const std::filesystem::path& folder) { loader_.open(folder); }

void ComparedResults::close() {
  if (!index_) return;
  loader_.close();
  index_.reset();
  frame_.reset();
  emit changed();
}

QString ComparedResults::name() const {
  return index_ ? QString::fromStdString(std::filesystem::weakly_canonical(index_->folder).stem().string()) : QString();
}

void ComparedResults::follow() {
  if (index_ && playback_.frame() && !index_->frame_times.empty())
    loader_.requestFrame(nearestFrame(index_->frame_times, playback_.time()));
}

}  // namespace talus
