#include "text/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace talus::cli {

namespace {

/// Redrawing more often than an eye follows would cost the solver time.
constexpr std::chrono::milliseconds redraw_interval{100};
constexpr int bar_width = 28;
/// Work that takes less than this leaves no lines in a log: an error then stands alone.
constexpr std::chrono::seconds quiet_start{2};

volatile std::sig_atomic_t interrupt_count = 0;
bool quiet = false;

/// `timeout` and batch systems send a signal to the process and to its group, so that it comes twice at once: that is
/// one wish to stop.
constexpr time_t seconds_of_one_wish = 1;
volatile time_t interrupted_at = 0;

/// s, of a clock that never goes back; safe in a signal handler.
time_t now_in_handler() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec;
}

extern "C" void on_interrupt(int signal_number) {
  const time_t now = now_in_handler();
  if (interrupt_count != 0 && now - interrupted_at > seconds_of_one_wish) {
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number);
  }
  if (interrupt_count == 0) interrupted_at = now;
  interrupt_count = 1;
}

/// Whether a line there can be drawn anew.
bool is_terminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && !(kind && std::strcmp(kind, "dumb") == 0);
}

int terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string bar(double fraction) {
  const int full = static_cast<int>(std::floor(fraction * bar_width));
  std::string text;
  for (int i = 0; i < bar_width; ++i) text += i < full ? "█" : "░";
  return text;
}

/// The first `width` characters of UTF-8.
std::string shortened(const std::string& text, int width) {
  std::size_t end = 0;
  for (int seen = 0; end < text.size(); ++end) {
    const bool starts = (static_cast<unsigned char>(text[end]) & 0xC0) != 0x80;
    if (starts && seen++ == width) break;
  }
  return text.substr(0, end);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  if (std::signal(SIGHUP, on_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // as nohup asks for
}

bool interrupted() { return interrupt_count != 0; }

void be_quiet() { quiet = true; }

std::string duration_text(double seconds) {
  const long whole = std::lround(std::max(0.0, seconds));
  char text[32];
  if (whole >= 3600)
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
  return text;
}

TerminalProgress::TerminalProgress() : start_(Clock::now()), terminal_(is_terminal()) {}

TerminalProgress::~TerminalProgress() { clear_bar(); }

void TerminalProgress::report(double fraction, std::string_view what) {
  if (quiet) return;
  fraction = std::clamp(fraction, 0.0, 1.0);
  if (terminal_)
    draw_bar(fraction, what);
  else
    print_line(fraction, what);
}

void TerminalProgress::draw_bar(double fraction, std::string_view what) {
  const auto now = Clock::now();
  if (now - drawn_ < redraw_interval && fraction < 1) return;
  drawn_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  char percent[16];
  std::snprintf(percent, sizeof percent, " %5.1f %%  ", 100 * fraction);
  std::string line = bar(fraction) + percent;
  if (fraction > 0 && elapsed > 1) line += duration_text(elapsed * (1 - fraction) / fraction) + " left  ";
  line += what;
  std::fprintf(stderr, "\r\033[K%s", shortened(line, terminal_width() - 1).c_str());
  std::fflush(stderr);
  bar_shown_ = true;
}

void TerminalProgress::print_line(double fraction, std::string_view what) {
  const int tenths = static_cast<int>(std::floor(10 * fraction));
  if (tenths == tenths_ || Clock::now() - start_ < quiet_start) return;
  tenths_ = tenths;
  std::fprintf(stderr, "%3d %%  %.*s\n", 10 * tenths, static_cast<int>(what.size()), what.data());
}

void TerminalProgress::clear_bar() {
  if (!bar_shown_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  bar_shown_ = false;
}

}  // namespace talus::cli
