#pragma once

#include <string>
#include <vector>

#include "results/run_report.hpp"
#include "run/motion_record.hpp"

namespace talus {

/// Says of every block how it moves: its class over the last part of its travel in the stage, and an event when the
/// class changes for good. Blocks that are held or have long been asleep are not looked at.
class MotionWatch {
 public:
  MotionWatch(const Project& project, const BlockSystem& system, const BodySet& bodies);

  /// After every step, with its contacts. `stage_ended`: it was the last of its stage.
  void look(double time, bool stage_ended, const BodySet& bodies, const std::vector<ContactSample>& contacts);
  /// One a block, as of the last step.
  const std::vector<MotionClass>& classes(const BodySet& bodies);
  /// "B2: sliding on J1 (B1)", "B2: sliding on J1 (B1), came to rest"; in order of time. Without falls, which are
  /// EventWatch's.
  const std::vector<Event>& events() const { return events_; }

  /// What it remembers from step to step.
  void archive(auto& state) { state(record_, classes_, followed_, stage_begins_, news_, events_); }

 private:
  /// What a block was last known to do, the last event that told of it, and what it will be once that has lasted.
  struct News {
    MotionClass known, told, next;
    double since = 0;  ///< s
    BlockPose from;    ///< when `next` began

    void archive(auto& state) { state(known, told, next, since, from); }
  };
  MotionClass class_of(int block) const;
  double travel(int block, const BlockPose& from, const BlockPose& to) const;
  double travel_since(int block, int span) const;
  bool accelerates(int block) const;
  int span_nearest_to(double time) const;
  int last_moving(int block) const;
  void tell(int block);

  MotionNames names_;
  MotionRecord record_;
  std::vector<MotionClass> classes_;
  std::vector<int> followed_;  ///< blocks whose class may still change
  bool stage_begins_ = true;
  std::vector<News> news_;
  std::vector<Event> events_;
};

}  // namespace talus
