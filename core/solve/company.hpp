#pragma once

#include <span>
#include <vector>

#include "bodies/body_set.hpp"
#include "contact/broad/box.hpp"
#include "model/project.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// What moves a block beyond the speed that it has.
struct Pull {
  double acceleration = 0;  ///< m/s², by gravity and loads at their largest
  double way = 0;           ///< m, by points that are held, or as a base that is moved

  /// The farthest way that it may go in a time [s] from a speed [m/s], alone: s = v t + ½ a t² [m].
  double farthest(double speed, double time) const { return speed * time + 0.5 * acceleration * time * time + way; }
};

/// Of each block, in a project as it holds in a stage.
std::vector<Pull> pulls_on_blocks(const Project& now, const BlockSystem& system);

/// How many of the blocks that may move can reach no other one from the start of a run to its end, as far as blocks
/// that touch none can go. A bound that a run does not lean on: see Company.
std::size_t blocks_alone_in_run(const Project& project, const BlockSystem& system, const StepTolerances& tolerances);

/// Who can come to touch another body, and who is alone. Each body is given a box that it will not leave soon: its own,
/// widened by how far it may go in the steps ahead, twice over, and by its diagonal, so that it may turn. Whose box
/// meets no other one is alone, and stays so until some body has gone as far as it was given: then the boxes are made
/// anew. So a body that goes farther than was foreseen, pushed by others or by a load, is found in company in time.
/// O(n log n) for n bodies when boxes are made, O(n) a step.
class Company {
 public:
  /// `always`: no body is ever alone. `never`: all are.
  enum class Choice { by_reach, always, never };

  Company(std::size_t bodies, const StepTolerances& tolerances, Choice choice);

  /// A stage begins: what pulls on each body, and which of them stand still, as they were built or are held.
  void begin_stage(std::vector<Pull> pulls, std::vector<bool> held);
  /// Whether boxes have to be made before contacts are sought up to `reach` [m].
  bool is_due(double reach) const;
  /// Makes them for a `time` ahead [s].
  void look(const BodySet& bodies, double time, double reach);

  /// A body has moved by no more than `displacement` [m].
  void moved(int body, double displacement);
  /// A step has been accepted.
  void step_taken();
  /// Whether an increment takes a body that is alone farther than it was given. Then it is given more, and boxes are
  /// due: the step is to be tried again.
  bool goes_too_far(const BodySet& bodies, const Increment& d);

  bool any() const { return in_company_ > 0; }  ///< body that may move is in company
  bool any_alone() const { return in_company_ < movable_; }
  bool is_alone(int body) const { return alone_[body]; }
  std::span<const char> alone() const { return alone_; }  ///< a body
  long looks() const { return looks_; }                   ///< how often boxes were made
  std::size_t never_met(const BodySet& bodies) const;     ///< bodies that were built to move and were alone so far
  double travelled(int body) const { return travelled_[body]; }  ///< m, since the last look

  /// What it remembers from step to step.
  void archive(auto& state) {
    state(alone_, met_, given_, travelled_, at_least_, gone_, speeds_, least_left_, steps_, in_company_, movable_);
    state(looks_);
  }

 private:
  void find_speeds(const BodySet& bodies);
  std::vector<Box> give_boxes(const BodySet& bodies, double time, double reach);

  StepTolerances tolerances_;
  Choice choice_;
  std::vector<Pull> pulls_;
  std::vector<bool> held_;
  std::vector<char> alone_, met_;     // a body
  std::vector<double> given_;         // m, a body: how far it may go
  std::vector<double> travelled_;     // m, a body
  std::vector<double> at_least_;      // m, a body: what a step that was tried took it
  std::vector<double> gone_;          // m, a body: in that step
  std::vector<double> speeds_;        // m/s, a body
  double least_left_ = -1;            // m, of what bodies were given
  int steps_ = 0;                     // since the last look
  int in_company_ = 0, movable_ = 0;  // bodies
  long looks_ = 0;
};

}  // namespace talus
