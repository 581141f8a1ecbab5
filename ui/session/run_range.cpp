#include "session/run_range.hpp"

#include "base/progress.hpp"
#include "jobs/background_job.hpp"
#include "session/current_project.hpp"
#include "session/playback.hpp"

namespace talus {

namespace {

constexpr int frames_at_once = 16;  // told of together: each telling draws the view anew

}  // namespace

RunRange::RunRange(CurrentProject& project, Playback& playback) : project_(project), playback_(playback) {
  connect(&playback_, &Playback::framesChanged, this, &RunRange::takeFrames);
}

RunRange::~RunRange() = default;

void RunRange::follow(const std::optional<Field>& field) {
  job_.reset();
  field_ = field;
  known_ = {};
  lastLive_.reset();
  takeFrames();
}

ValueRange RunRange::rangeOf(const Frame& frame) const {
  if (!field_ || !project_.system()) return {};
  if (system_ != project_.system()) {
    fields_.reset();
    system_ = project_.system();
  }
  if (!fields_) fields_ = std::make_unique<const FieldValues>(*system_);
  return field_range(*fields_, frame, *field_);
}

bool RunRange::isWhole() const { return !field_ || whole_.contains(std::string(field_->name)); }

void RunRange::takeFrames() {
  if (playback_.folder() != folder_ || playback_.times().empty()) {
    // Another run: nothing of the one before may be read any more. Of one that has just ended all is known already.
    const bool justEnded = folder_.empty() && lastLive_ && !playback_.folder().empty();
    job_.reset();
    folder_ = playback_.folder();
    whole_.clear();
    lastLive_.reset();
    if (!justEnded) known_ = {};
  }
  if (!field_ || !project_.system()) return;
  for (const auto& frame : playback_.liveFrames()) {
    if (lastLive_ && frame->time <= *lastLive_) continue;
    lastLive_ = frame->time;
    known_.include(rangeOf(*frame));
  }
  if (!folder_.empty() && !playback_.times().empty() && !job_) readAll();
}

void RunRange::readAll() {
  if (const auto before = whole_.find(std::string(field_->name)); before != whole_.end()) {
    known_ = before->second;
    return;
  }
  job_ = std::make_unique<BackgroundJob>();
  const int count = static_cast<int>(playback_.times().size());
  const auto read = [system = project_.system(), source = playback_.source(), field = *field_, count](
                        Progress& progress, const auto& tell) {
    ValueRange range;
    const FieldValues fields(*system);
    try {
      for (int i = 0; i < count; ++i) {
        if (progress.cancelled()) throw Cancelled{};
        range.include(field_range(fields, *source(i), field));
        if (i % frames_at_once == frames_at_once - 1) tell(range);
      }
    } catch (const std::exception&) {
      // A frame that cannot be read is told of where it is shown; the range is that of the others.
    }
    tell(range);
  };
  job_->start<ValueRange>(read, [this](const ValueRange& range) { include(range); });
  connect(job_.get(), &BackgroundJob::ended, this, [this] { whole_[std::string(field_->name)] = known_; });
}

void RunRange::include(const ValueRange& range) {
  known_.include(range);
  emit changed();
}

}  // namespace talus
