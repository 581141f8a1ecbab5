#pragma once

#include <vector>

#include "bodies/block_pose.hpp"
#include "results/frame.hpp"
#include "run/motion_window.hpp"

namespace talus {

/// What a block's contacts carried in a span of time.
struct CarriedLoad {
  /// A face of another block by joint and normal; sums weighted by impulse.
  struct Face {
    int block, joint;
    Vec3 normal, moment;  ///< N·s, N·s·m
    double impulse;       ///< N·s

    void archive(auto& state) { state(block, joint, normal, moment, impulse); }
  };
  std::vector<Face> faces;
  double free_time = 0;  ///< s, in which it moved and bore on nothing

  void archive(auto& state) { state(faces, free_time); }

  void add(const Face& face);
  void add(const CarriedLoad& later);
};

/// The motion of all blocks since their stage began, in some hundred spans however long the stage is: when there are
/// too many, neighbours become one. A span says what happened within a hundredth of the stage's time so far. Blocks
/// that are held or sleep leave no trace and cost nothing.
class MotionRecord {
 public:
  MotionRecord(const Project& project, const BlockSystem& system, const BodySet& bodies);

  /// After a step, with the contacts of those that move; true when a span was completed by it.
  bool take(double time, bool stage_ended, const BodySet& bodies, const std::vector<ContactSample>& contacts);
  /// Takes the present poses for those of the end of the span that is growing.
  void catch_up(const BodySet& bodies);

  int spans() const { return static_cast<int>(ends_.size()); }  ///< of the stage, with the one that is growing
  double begin() const { return begin_; }                       ///< s, of the stage
  double end(int span) const { return ends_[span]; }            ///< s
  double end() const { return ends_.back(); }                   ///< s
  /// At the end of a span; −1: at the start of the stage.
  const BlockPose& pose(int block, int span) const;
  const BlockPose& last_pose(int block) const { return pose(block, spans() - 1); }
  const PoseFit& fit() const { return fit_; }

  /// What a block did between two spans' ends, `from` = −1 for the stage's start, `from` < `to`.
  MotionWindow window(int block, int from, int to) const;

  /// What it remembers from step to step.
  void archive(auto& state) { state(time_, begin_, length_, stage_begins_, grows_, start_, ends_, tracks_, passing_); }

 private:
  /// A span in which a block moved: where it was at the end, and what it bore on.
  struct Passage {
    int span;
    BlockPose pose;
    CarriedLoad load;

    void archive(auto& state) { state(span, pose, load); }
  };
  using Track = std::vector<Passage>;  ///< of a block, in order of time
  void begin_stage(double time);
  void begin_span();
  Passage& growing(int block);
  void add_contacts(double length, const std::vector<ContactSample>& contacts, const BodySet& bodies);
  void thin();

  PoseFit fit_;
  std::vector<double> weight_;  ///< N, a block
  std::vector<bool> yields_;    ///< a block: free to move, as far as it was built
  Vec3 up_ = Vec3::Zero();
  double time_ = 0, begin_ = 0, length_ = 0;  ///< s, of the last step's end; of the stage; of a span
  bool stage_begins_ = true, grows_ = false;
  std::vector<BlockPose> start_;  ///< of the stage
  std::vector<double> ends_;      ///< s, of spans
  std::vector<Track> tracks_;     ///< a block
  std::vector<int> passing_;      ///< blocks with a passage in the span that is growing
  std::vector<double> force_;     ///< N, a block, of one step
};

/// The small motion between two poses.
SmallMotion motion_between(const BlockPose& from, const BlockPose& to);

}  // namespace talus
