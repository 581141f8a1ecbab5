#include "geometry/mesher_answers.hpp"

#include <stdexcept>

#include "base/error.hpp"
#include "geometry/splinters_found.hpp"

namespace talus {
namespace {

[[noreturn]] void throw_error(const MesherError& error) {
  if (error.splinters.empty()) throw InputError(error.place, error.problem, error.remedy);
  throw SplintersFound(error.place, error.problem, error.remedy, {error.splinters.begin(), error.splinters.end()});
}

}  // namespace

void MesherAnswers::hear(double fraction, const std::string& what) {
  last_fraction_ = fraction;
  last_words_ = what;
  heard_ = Clock::now();
  seconds_told_ = 0;
  progress_.report(fraction, what);
}

void MesherAnswers::wait_on() {
  const auto seconds = static_cast<int>(std::chrono::floor<std::chrono::seconds>(Clock::now() - heard_).count());
  if (seconds == seconds_told_) return;
  seconds_told_ = seconds;
  progress_.report(last_fraction_, last_words_ + ", for " + std::to_string(seconds) + " s");
}

/// What a user's file does to the libraries that read it is no fault of the program.
bool MesherAnswers::is_reading() const { return last_words_.starts_with(words_of_reading); }

std::string MesherAnswers::remedy() const {
  return is_reading() ? "export the file again, or in another format" : remedy_;
}

MesherProcess::Message MesherAnswers::next() {
  constexpr int patience = 50;  // ms, how long a cancelled wait may last
  for (;;) {
    const bool come = mesher_.wait(patience);
    if (progress_.cancelled()) throw Cancelled{};
    if (!come) {
      wait_on();
      continue;
    }
    auto message = mesher_.receive();
    if (!message) throw InputError("geometry", "the mesher crashed while " + last_words_, remedy());
    if (message->kind == MessageKind::progress) {
      const auto told = from_bytes<MesherProgress>(message->bytes);
      hear(told.fraction, told.what);
    } else if (message->kind == MessageKind::error) {
      throw_error(from_bytes<MesherError>(message->bytes));
    } else if (message->kind == MessageKind::fault) {
      const std::string fault =
          "the mesher failed while " + last_words_ + ": " + from_bytes<MesherFault>(message->bytes).what;
      if (is_reading()) throw InputError("geometry", fault, remedy());
      throw std::runtime_error(fault);
    } else {
      return std::move(*message);
    }
  }
}

}  // namespace talus
