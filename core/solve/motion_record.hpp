#pragma once

#include <vector>

#include "bodies/block_pose.hpp"
#include "results/frame.hpp"
#include "solve/motion_window.hpp"

namespace talus {

/// What a block's contacts carried in a span of time.
struct CarriedLoad {
  /// A face of another block by joint and normal; sums weighted by impulse.
  struct Face {
    int block, joint;
    Vec3 normal, moment;  ///< N·s, N·s·m
    double impulse;       ///< N·s
  };
  std::vector<Face> faces;
  double loaded_time = 0;  ///< s

  void add(const Face& face);
  void add(const CarriedLoad& later);
};

/// A piece of a stage: where all blocks were at its end, and what they bore on until then.
struct MotionSpan {
  double begin = 0, end = 0;       ///< s
  std::vector<BlockPose> poses;    ///< a block
  std::vector<CarriedLoad> loads;  ///< a block
};

/// The motion of all blocks since their stage began, in some hundred spans however long the stage is: when there are
/// too many, neighbours become one. A span says what happened within a hundredth of the stage's time so far.
class MotionRecord {
 public:
  MotionRecord(const Project& project, const BlockSystem& system, const BodySet& bodies);

  /// After a step, with its contacts; true when a span was completed by it.
  bool take(double time, bool stage_ended, const BodySet& bodies, const std::vector<ContactSample>& contacts);
  /// The spans of the stage, the one that is growing included; none before the first step.
  std::vector<const MotionSpan*> spans(const BodySet& bodies);
  const std::vector<BlockPose>& start() const { return start_; }  ///< of the stage
  const PoseFit& fit() const { return fit_; }

  /// What block `b` did between two spans' ends, `from` = −1 for the stage's start, `from` < `to`.
  MotionWindow window(const std::vector<const MotionSpan*>& spans, int b, int from, int to) const;

 private:
  void begin_stage(double time);
  void add_contacts(double length, const std::vector<ContactSample>& contacts, const BodySet& bodies);
  void complete(const BodySet& bodies);
  void thin();

  PoseFit fit_;
  std::vector<double> weight_;  ///< N, a block
  std::vector<bool> yields_;    ///< a block: free to move, as far as it was built
  Vec3 up_ = Vec3::Zero();
  double time_ = 0, length_ = 0;  ///< s, of the last step's end; of a span
  bool stage_begins_ = true;
  std::vector<BlockPose> start_, last_;
  std::vector<MotionSpan> done_;
  MotionSpan growing_;
  std::vector<double> force_;  ///< N, a block, of one step
};

/// The small motion between two poses.
SmallMotion motion_between(const BlockPose& from, const BlockPose& to);

}  // namespace talus
