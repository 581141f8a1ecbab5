#pragma once

#include <vector>

#include "model/project.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Where a run stands in its stages: which step is next, how long it may be, and when it ends.
class StageClock {
 public:
  /// `rounding`: of a step's length, what counts as nothing.
  explicit StageClock(const std::vector<Stage>& stages, double rounding = StepTolerances{}.time_rounding);

  bool finished() const { return stage_ == static_cast<int>(spans_.size()); }
  int stage() const { return stage_; }  ///< index into Project::stages, of the next step
  bool stage_begins() const { return begins_; }
  bool stage_ended() const { return begins_ && stage_ > 0; }  ///< the last call finished a stage
  double time() const { return time_; }                       ///< s, at the start of the next step
  double next_length() const;  ///< s, of a fixed step; the last step of a duration may be shorter
  double left() const;         ///< s, of the stage
  bool is_last() const;        ///< the next step, if its length is fixed, is the last of its stage
  double end() const;          ///< s, of the whole run, if no stage ends before its time
  long total_steps() const;    ///< of fixed length, in all stages

  /// The next step of fixed length is done.
  void advance();
  /// A step of this length [s] is done; what rounding leaves of the stage does not count.
  void advance_by(double length);
  /// The stage has come to its end before its time.
  void end_stage();

  /// Where it stands.
  void archive(auto& state) { state(stage_, begins_, step_, time_, start_); }

 private:
  struct Span {
    double length, duration;  ///< s
    long steps;
    double last;  ///< s, the last step
  };
  double rounding_;
  std::vector<Span> spans_;
  int stage_ = 0;
  bool begins_ = true;
  long step_ = 0;
  double time_ = 0, start_ = 0;  ///< s, now, and at the start of the stage
};

}  // namespace talus
