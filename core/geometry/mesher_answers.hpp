#pragma once

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

  /// The next message that is neither progress nor error. Throws Cancelled as soon as `progress` says so, InputError
  /// for the mesher's errors and where it crashed, std::runtime_error for its faults.
  MesherProcess::Message next();

 private:
  MesherProcess& mesher_;
  Progress& progress_;
  std::string remedy_;
  std::string last_words_ = "starting";
};

}  // namespace talus
