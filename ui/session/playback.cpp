#include "session/playback.hpp"

#include <algorithm>
#include <limits>

#include "document/document.hpp"
#include "jobs/results_loader.hpp"
#include "session/messages.hpp"

namespace talus {

int nearestFrame(const std::vector<double>& times, double time) {
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return 0;
  if (after == times.end()) return static_cast<int>(times.size()) - 1;
  const auto before = std::prev(after);
  return static_cast<int>((time - *before < *after - time ? before : after) - times.begin());
}

std::function<std::shared_ptr<const Frame>(int)> framesOf(const std::filesystem::path& folder) {
  const auto reader = std::make_shared<std::unique_ptr<ResultReader>>();
  return [reader, folder](int number) {
    if (!*reader) *reader = std::make_unique<ResultReader>(folder);
    return std::make_shared<const Frame>((*reader)->frame(number));
  };
}

Playback::Playback(Document& document, Messages& messages)
    : document_(document), loader_(std::make_unique<ResultsLoader>()) {
  connect(loader_.get(), &ResultsLoader::opened, this, [this](const auto& index) { takeIndex(*index); });
  connect(loader_.get(), &ResultsLoader::frameReady, this, &Playback::takeFrame);
  connect(loader_.get(), &ResultsLoader::failed, this, [this, &messages](const InputError& error) {
    waiting_ = false;
    messages.add(problemOf(error, Problem::Of::results));
  });
  connect(&document, &Document::projectChanged, this, &Playback::framesChanged);
}

Playback::~Playback() = default;

bool Playback::isCurrent() const { return solved_ == document_.project(); }

void Playback::clear() {
  loader_->close();
  liveFrames_.clear();
  frame_.reset();
  times_.clear();
  number_ = -1;
  live_ = waiting_ = loading_ = false;
  solved_.reset();
  following_ = true;
  wantedTime_.reset();
  folder_.clear();
  emit framesChanged();
  emit frameChanged();
}

void Playback::open(const std::filesystem::path& folder) {
  solved_ = document_.project();
  load(folder);
}

void Playback::beginRun() {
  live_ = true;
  solved_ = document_.project();
}

void Playback::add(const std::vector<std::shared_ptr<const Frame>>& frames) {
  for (const auto& frame : frames) liveFrames_.add(frame);
  times_.clear();
  for (const auto& frame : liveFrames_.frames()) times_.push_back(frame->time);
  emit framesChanged();
  if (following_) showFrame(static_cast<int>(times_.size()) - 1);
}

void Playback::showMoment(std::shared_ptr<const Frame> moment) {
  if (live_ && following_ && !times_.empty()) takeFrame(std::move(moment));
}

void Playback::endRun(const std::filesystem::path& folder) {
  wantedTime_ = frame_ ? std::optional<double>(frame_->time) : std::nullopt;
  load(folder);
}

void Playback::readAgain() {
  wantedTime_ = following_ || !frame_ ? std::numeric_limits<double>::infinity() : frame_->time;
  load(folder_);
}

void Playback::load(const std::filesystem::path& folder) {
  loading_ = true;
  loader_->open(folder);
}

void Playback::takeIndex(const ResultsIndex& index) {
  const std::optional<double> wanted = std::exchange(wantedTime_, std::nullopt);
  live_ = loading_ = false;
  liveFrames_.clear();
  folder_ = index.folder;
  times_ = index.frame_times;
  number_ = -1;
  emit resultsOpened(index, wanted.has_value());
  emit framesChanged();
  if (wanted)
    showTime(*wanted);
  else
    showFrame(static_cast<int>(times_.size()) - 1);
}

void Playback::takeFrame(std::shared_ptr<const Frame> frame) {
  waiting_ = false;
  frame_ = std::move(frame);
  emit frameChanged();
}

void Playback::showFrame(int number) {
  if (times_.empty()) return;
  number = std::clamp(number, 0, static_cast<int>(times_.size()) - 1);
  following_ = number == static_cast<int>(times_.size()) - 1;
  number_ = number;
  if (live_) {
    takeFrame(liveFrames_.frames()[static_cast<size_t>(number)]);
  } else {
    waiting_ = true;
    loader_->requestFrame(number);
  }
}

void Playback::showTime(double seconds) {
  if (!times_.empty()) showFrame(nearestFrame(times_, seconds));
}

std::function<std::shared_ptr<const Frame>(int)> Playback::source() const {
  if (live_) return [frames = liveFrames_.frames()](int number) { return frames.at(static_cast<size_t>(number)); };
  return framesOf(folder_);
}

void Playback::setExporting(bool exporting) {
  exporting_ = exporting;
  emit framesChanged();
}

}  // namespace talus
