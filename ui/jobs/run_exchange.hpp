#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "run/effect_costs.hpp"
#include "run/run.hpp"

namespace talus {

/// News are taken ten times a second: quick to the eye, cheap for the window.
inline constexpr int heartbeat_ms = 100;

/// A run whose frames come less often shows where blocks are between them: four times a second, which costs a run of
/// a thousand blocks less than a thousandth.
inline constexpr std::chrono::milliseconds between_moments{250};

/// What a job has done since it was last asked.
struct JobNews {
  double fraction = 0;  ///< 0…1 of the work that goes on: meshing or solving
  std::string what;     ///< a few words while meshing
  bool solving = false;
  std::shared_ptr<const BlockSystem> system;  ///< once, when meshing is done
  std::vector<StepReport> steps;
  std::vector<HistoryRow> history;  ///< one for each of `steps`
  int iterations = 0;               ///< of the step that is being made, so far
  double unbalanced = 0;            ///< N, in the last of them
  std::vector<std::shared_ptr<const Frame>> frames;
  std::shared_ptr<const Frame> moment;       ///< later than these, and not written; null: none
  std::optional<SceneSize> size;             ///< once, after `system`: what the effects will be paid for
  std::vector<EffectOutcome> effects;        ///< what they have cost so far; empty where nothing new is known
  std::vector<ConvergenceTrouble> troubles;  ///< the hardest places so far; empty where nothing new is known
};

/// Where the solving thread and the window's thread meet. The worker never waits for the window; the window takes what
/// has gathered when it has time, so that a fast run cannot flood it.
class RunExchange final : public Progress, public RunObserver {
 public:
  // On the working thread.
  void report(double fraction, std::string_view what) override;
  bool cancelled() const override;
  void on_step(const StepReport& step, const HistoryRow& history, double fraction) override;
  void on_iteration(double unbalanced) override;
  void on_frame(std::shared_ptr<const Frame> frame) override;
  bool wants_moment() override;
  void on_moment(std::shared_ptr<const Frame> frame) override;
  void on_effects(const std::vector<EffectOutcome>& effects) override;
  void on_troubles(const std::vector<ConvergenceTrouble>& troubles) override;
  bool go_on() override;
  void meshed(std::shared_ptr<const BlockSystem> system);
  void sized(const SceneSize& size);

  // On the window's thread.
  void pause();
  void resume();
  /// Lets a paused run make this many steps and pauses again.
  void allowSteps(int count);
  void stop();
  JobNews take();

 private:
  mutable std::mutex mutex_;
  std::condition_variable woken_;
  std::optional<long> allowed_;  ///< steps that may still be made; empty: any number
  bool stopped_ = false;
  std::chrono::steady_clock::time_point last_frame_ = std::chrono::steady_clock::now();
  JobNews news_;
};

}  // namespace talus
