#include "study/forecast/forecast.hpp"

#include <algorithm>
#include <cmath>

#include "base/part_of_progress.hpp"
#include "base/processor_time.hpp"
#include "model/stage_length.hpp"
#include "study/forecast/run_beginning.hpp"
#include "study/forecast/run_outline.hpp"
#include "study/forecast/step_doubling.hpp"

namespace talus {

namespace {

/// Shares of the budget. Half as long steps are twice as many.
constexpr double of_beginning = 0.4, of_outline = 0.2, of_finer = 0.4;
/// Of a long run more is seen of the beginning than its share of the budget lasts for, and of the outline, too.
constexpr double outline_of_beginning = of_outline / of_beginning;
/// Of a run that was made itself, for the same in half steps: what is left.
constexpr double of_doubling = of_outline + of_finer;
/// What was not seen comes within this factor of what was foreseen, where the stage had begun, …
constexpr double spread = 1.5;
/// … within this one where none of its steps were seen, or the outline did not come to its end, …
constexpr double spread_unseen = 2;
/// … and within this one where only first steps were.
constexpr double spread_first = 3;
/// Seconds of the processor that were measured come out again within this factor: who shares its caches decides.
constexpr double spread_measured = 1.2;
/// Fewer steps than these have more iterations than those that follow: a run finds out in its first ones which contacts
/// bear and which slip.
constexpr std::size_t first_steps = 20;

/// Steps that speak for those that were not seen, and what they cost, each as long as its stage's time_step.
struct Sample {
  int stage = -1;
  double from = 0, to = 0;  ///< s since the stage began
  double searching = 0;     ///< s of the processor a step, for contacts, …
  double iterating = 0;     ///< … for what each iteration does again …
  double other = 0;         ///< … and for everything else
  double iterations = 0;    ///< a step
  bool of_first = false;    ///< the stage's first steps only
};

/// The second half: in the first what has just begun is not yet typical.
Sample sample_of(int number, const Stage& stage, const StageBeginning& seen) {
  Sample sample;
  sample.stage = number;
  for (std::size_t i = 0; i < seen.steps.size(); ++i) {
    const TimedStep& step = seen.steps[i];
    sample.to += step.length;
    if (i < seen.steps.size() / 2) {
      sample.from = sample.to;
    } else {
      sample.searching += step.detecting * step.seconds;
      sample.iterating += step.iterating * step.seconds;
      sample.iterations += step.iterations;
      sample.other += (1 - step.detecting - step.iterating) * step.seconds;
    }
  }
  const double steps = (sample.to - sample.from) / stage.time_step;
  sample.searching /= steps;
  sample.iterating /= steps;
  sample.iterations /= steps;
  sample.of_first = seen.steps.size() < first_steps;
  sample.other /= steps;
  return sample;
}

/// Seconds that were measured, and those that are foreseen.
class Sum {
 public:
  void add_measured(double seconds) { measured_ += seconds; }
  /// `unchanged`: what they would be if there were as much to do as in the sample.
  void add_foreseen(double seconds, double unchanged, double within, bool may_end_sooner) {
    foreseen_ += seconds;
    if (!may_end_sooner) fewest_ += std::min(seconds, unchanged) / within;
    most_ += std::max(seconds, unchanged) * within;
  }
  void tell(Forecast& forecast) const {
    forecast.seconds = measured_ + foreseen_;
    forecast.fewest = measured_ / spread_measured + fewest_;
    forecast.most = measured_ * spread_measured + most_;
    forecast.share_seen = forecast.seconds > 0 ? measured_ / forecast.seconds : 1;
  }

 private:
  double measured_ = 0, foreseen_ = 0, fewest_ = 0, most_ = 0;
};

/// How many times as much there is to do from `from` to `to` [s] of a stage as in the sample: contacts, unknowns, and
/// iterations where only first steps were seen and blocks touch. Later ones have about as many as those of the outline;
/// a step without any looks at its equations once, too.
RunOutline::Load growth(const RunOutline& outline, const Sample& sample, int stage, double from, double to) {
  const auto here = outline.load(sample.stage, sample.from, sample.to);
  auto there = outline.load(stage, from, to);
  if (!there) there = outline.last();  // as far as it came
  if (!there || !here) return {1, 1, 1};
  const bool fewer = sample.of_first && there->contacts > 0;
  return {here->contacts > 0 ? there->contacts / here->contacts : 1, here->awake > 0 ? there->awake / here->awake : 1,
          fewer ? std::min(1.0, (1 + there->iterations) / (1 + sample.iterations)) : 1};
}

void add_up(const Project& project, const RunBeginning& beginning, const RunOutline& outline, Forecast& forecast) {
  Sum sum;
  sum.add_measured(beginning.around);
  Sample sample;
  for (int k = 0; k < static_cast<int>(project.stages.size()); ++k) {
    const Stage& stage = project.stages[k];
    const StageBeginning seen = k < static_cast<int>(beginning.stages.size()) ? beginning.stages[k] : StageBeginning{};
    double length = 0;
    for (const TimedStep& step : seen.steps) {
      sum.add_measured(step.seconds);
      length += step.length;
    }
    if (!seen.steps.empty()) sample = sample_of(k, stage, seen);
    const double steps = (length_of(stage) - length) / stage.time_step;
    if (beginning.whole || seen.ended || sample.stage < 0 || steps < 0.5) continue;
    const auto more = growth(outline, sample, k, length, length_of(stage));
    const double iterating = sample.iterating * more.iterations;
    const bool unseen = seen.steps.empty() || !outline.came_through();
    const double to_come = steps_to_end(stage, seen, steps);
    sum.add_foreseen(to_come * (sample.searching * more.contacts + (iterating + sample.other) * more.awake),
                     steps * (sample.searching + iterating + sample.other),
                     sample.of_first ? spread_first
                     : unseen        ? spread_unseen
                                     : spread,
                     stage.until_equilibrium);
  }
  sum.tell(forecast);
}

/// Largest difference of the displacements of blocks, over the largest displacement; empty where nothing moves.
std::optional<double> difference(const RunOutline& a, const RunOutline& b) {
  double largest = 0, apart = 0;
  for (std::size_t i = 0; i < a.displacements().size(); ++i) {
    largest = std::max(largest, a.displacements()[i].norm());
    apart = std::max(apart, (a.displacements()[i] - b.displacements()[i]).norm());
  }
  if (largest == 0) return std::nullopt;
  return apart / largest;
}

/// By step doubling of the outline, which knows what blocks do as a whole and nothing of strain.
std::optional<double> error_in_outline(const Project& project, const BlockSystem& system, const RunOutline& outline,
                                       double budget, Progress& progress) {
  const RunOutline finer(project, system, 2, budget, progress);
  const auto apart = finer.came_through() ? difference(outline, finer) : std::nullopt;
  if (!apart) return std::nullopt;
  return *apart * 2 / longest_leap(project);
}

bool has_order_in_the_step(const Project& project) {
  return project.solver.time_step_control == TimeStepControl::fixed && longest_leap(project) > 1;
}

}  // namespace

Forecast forecast(const Project& project, const BlockSystem& system, double budget, Progress& progress) {
  const double begin = processor_seconds_of_thread();
  PartOfProgress first(progress, 0, of_beginning, "the first steps"),
      second(progress, of_beginning, of_outline, "the run in outline"),
      third(progress, of_beginning + of_outline, of_finer, "the same in half steps");
  Forecast result;
  for (const Stage& stage : project.stages) result.steps += std::lround(std::ceil(length_of(stage) / stage.time_step));
  const RunBeginning beginning = run_beginning(project, system, of_beginning * budget, first);
  result.memory = beginning.memory;
  result.failure = beginning.failure;
  const double for_outline = std::max(of_outline * budget, outline_of_beginning * beginning.seconds);
  const RunOutline outline(project, system, 1, for_outline, second);
  add_up(project, beginning, outline, result);
  if (has_order_in_the_step(project)) {
    if (beginning.whole && cost_of_step_doubling * result.seconds < of_doubling * budget)
      result.error = error_by_step_doubling(project, system, of_doubling * budget, third);
    else if (outline.came_through())
      result.error = error_in_outline(project, system, outline, of_finer * budget, third);
  }
  result.forecast_seconds = processor_seconds_of_thread() - begin;
  return result;
}

}  // namespace talus
