#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "base/progress.hpp"

namespace talus::cli {

/// Makes Ctrl-C (and a polite kill) set a flag instead of ending the program; one that comes two
/// seconds later ends it at once.
void catch_interrupts();
bool interrupted();

/// From now on nothing says how far work is (`--quiet`).
void be_quiet();

/// How far a long piece of work is, on standard error: a bar that is redrawn on a terminal, elsewhere a plain line at
/// every tenth. Cancelled by Ctrl-C once `catch_interrupts` was called.
class TerminalProgress final : public Progress {
 public:
  TerminalProgress();
  ~TerminalProgress() override;

  void report(double fraction, std::string_view what) override;
  bool cancelled() const override { return interrupted(); }
  /// Takes the bar away before something else is printed; the next report draws it again.
  void clear_bar();

 private:
  void draw_bar(double fraction, std::string_view what);
  void print_line(double fraction, std::string_view what);

  using Clock = std::chrono::steady_clock;
  Clock::time_point start_, drawn_;
  const bool terminal_;
  bool bar_shown_ = false;
  int tenths_ = -1;
};

/// Hours, minutes and seconds: "1:02:03" or "2:03".
std::string duration_text(double seconds);

}  // namespace talus::cli
