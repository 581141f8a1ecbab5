#include "jobs/live_frames.hpp"

#include <algorithm>

namespace talus {

std::size_t frame_bytes(const Frame& frame) {
  return sizeof(Frame) + frame.displacement.size() * sizeof(Vec3) + frame.velocity.size() * sizeof(Vec3) +
         frame.stress.size() * sizeof(Voigt) + frame.contacts.size() * sizeof(ContactSample);
}

void LiveFrames::clear() {
  frames_.clear();
  bytes_ = 0;
  stride_ = 1;
}

void LiveFrames::add(std::shared_ptr<const Frame> frame) {
  if (!frames_.empty() && frames_.back()->index % stride_ != 0) {
    bytes_ -= frame_bytes(*frames_.back());
    frames_.pop_back();
  }
  bytes_ += frame_bytes(*frame);
  frames_.push_back(std::move(frame));
  thin();
}

void LiveFrames::thin() {
  if (bytes_ <= budget_ || frames_.size() < 3) return;
  stride_ *= 2;
  const auto newest = frames_.back();
  std::erase_if(frames_, [&](const auto& frame) { return frame != newest && frame->index % stride_ != 0; });
  bytes_ = 0;
  for (const auto& frame : frames_) bytes_ += frame_bytes(*frame);
}

}  // namespace talus
