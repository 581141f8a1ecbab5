#pragma once

#include <string_view>

namespace talus {

/// What a long piece of work tells the one who waits for it, and how it is told to stop.
/// Called from the working thread; implementations must be safe to read from another.
class Progress {
 public:
  virtual ~Progress() = default;
  /// `fraction` in 0…1 of the current piece of work, `what` a few words ("meshing block 12 of 40").
  virtual void report(double fraction, std::string_view what) = 0;
  virtual bool cancelled() const = 0;
};

/// Nobody waits.
class NoProgress final : public Progress {
 public:
  void report(double, std::string_view) override {}
  bool cancelled() const override { return false; }
};

/// Thrown by work that found `Progress::cancelled()` true; nothing half-made is left behind.
struct Cancelled {};

}  // namespace talus
