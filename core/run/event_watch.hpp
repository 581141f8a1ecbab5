#pragma once

#include <string>
#include <vector>

#include "bodies/block_motion.hpp"
#include "results/frame.hpp"
#include "results/run_report.hpp"

namespace talus {

struct BlockSystem;

class Simulation;

/// Watches a run for what deserves a mark on its timeline, each told once: a joint between two blocks that has opened
/// so far that one sees it, a block that has flown free for a while, a block that has begun to topple. Looks at the
/// blocks that move alone.
class EventWatch {
 public:
  explicit EventWatch(const BlockSystem& system);

  /// After a step.
  void look(const Simulation& simulation);
  /// In order of time.
  std::vector<Event> events() const;

  /// What it remembers from step to step.
  void archive(auto& state) { state(joints_, joints_of_, flights_, motions_, toppled_, last_look_, events_); }

 private:
  struct Joint {
    int blocks[2];
    int joint;
    bool closed = true, told = false;
    Vec3 apart_at_opening = Vec3::Zero();  ///< m, difference of the blocks' displacements when the last contact opened

    void archive(auto& state) { state(blocks, joint, closed, told, apart_at_opening); }
  };
  struct Flight {
    bool touched = false, touches = false, told = false;
    double since = 0;      ///< s
    double looked_at = 0;  ///< s

    void archive(auto& state) { state(touched, touches, told, since, looked_at); }
  };
  void mark_closed(const ContactSample& contact);
  void look_at(Joint& joint, double time);
  void look_at_block(int block, double time);

  const BlockSystem& system_;
  std::vector<Joint> joints_;
  std::vector<std::vector<int>> joints_of_;  ///< a block
  std::vector<Flight> flights_;
  std::vector<BlockMotion> motions_;
  std::vector<bool> toppled_;
  double last_look_ = 0;  ///< s
  std::vector<Event> events_;
};

}  // namespace talus
