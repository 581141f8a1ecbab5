#pragma once

#include <chrono>
#include <string>

#include "base/progress.hpp"
#include "geometry/mesher_process.hpp"

namespace talus {

/// What the mesher answers, with its progress passed on and its errors thrown.
class MesherAnswers {
 public:
  /// `remedy`: what the user can do when the mesher dies.
  MesherAnswers(MesherProcess& mesher, Progress& progress, std::string remedy)
      : mesher_(mesher), progress_(progress), remedy_(std::move(remedy)) {}

  /// The next message that is neither progress nor error. While the mesher is silent, as in one long call of
  /// OpenCASCADE, its last words are repeated each second, with for how long they have been true. Throws Cancelled as
  /// soon as `progress` says so, InputError for the mesher's errors, where it crashed, and where it failed while it
  /// read a file; std::runtime_error for other faults.
  MesherProcess::Message next();

 private:
  using Clock = std::chrono::steady_clock;

  void hear(double fraction, const std::string& what);
  void wait_on();
  bool is_reading() const;
  std::string remedy() const;

  MesherProcess& mesher_;
  Progress& progress_;
  std::string remedy_;
  std::string last_words_ = "starting";
  double last_fraction_ = 0;
  Clock::time_point heard_ = Clock::now();
  int seconds_told_ = 0;
};

}  // namespace talus
