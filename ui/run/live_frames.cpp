#include "run/live_frames.hpp"

#include <algorithm>

namespace talus {

std::size_t frame_bytes(const Frame& frame) {
  return sizeof(Frame) + frame.displacement.size() * sizeof(Vec3) + frame.velocity.size() * sizeof(Vec3) +
         frame.stress.size() * sizeof(Voigt) + frame.contacts.size() * sizeof(ContactSample);
}

void LiveFrames::clear() {
  frames_.clear();
  stride_ = 1;
}

void LiveFrames::add(std::shared_ptr<const Frame> frame) {
  if (!frames_.empty() && frames_.back()->index % stride_ != 0) frames_.pop_back();
  frames_.push_back(std::move(frame));
  thin();
}

void LiveFrames::thin() {
  std::size_t bytes = 0;
  for (const auto& frame : frames_) bytes += frame_bytes(*frame);
  if (bytes <= budget_ || frames_.size() < 3) return;
  stride_ *= 2;
  const auto newest = frames_.back();
  std::erase_if(frames_, [&](const auto& frame) { return frame != newest && frame->index % stride_ != 0; });
}

}  // namespace talus
