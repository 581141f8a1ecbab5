#pragma once

#include <vector>

#include "model/project.hpp"

namespace talus {

/// Where a run stands in its stages: which step is next, how long it is, and when it ends.
class StageClock {
 public:
  explicit StageClock(const std::vector<Stage>& stages);

  bool finished() const { return stage_ == static_cast<int>(stages_.size()); }
  int stage() const { return stage_; }  ///< index into Project::stages, of the next step
  bool stage_begins() const { return step_ == 0; }
  bool stage_ended() const { return step_ == 0 && stage_ > 0; }  ///< the last advance() finished a stage
  double time() const { return time_; }                          ///< s, at the start of the next step
  double next_length() const;                                    ///< s; the last step of a duration may be shorter
  double end() const { return end_; }                            ///< s, of the whole run
  long total_steps() const { return total_steps_; }
  void advance();

 private:
  struct Span {
    double start, length;
    long steps;
    double last;
  };
  std::vector<Stage> stages_;
  std::vector<Span> spans_;
  int stage_ = 0;
  long step_ = 0;
  double time_ = 0, end_ = 0;
  long total_steps_ = 0;
};

}  // namespace talus
