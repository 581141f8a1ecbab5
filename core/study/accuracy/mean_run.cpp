#include "study/accuracy/mean_run.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

template <typename Thing>
void average(Thing& mean, const auto& things, auto member) {
  double sum = 0;
  for (const Thing& thing : things) sum += static_cast<double>(thing.*member);
  sum /= static_cast<double>(things.size());
  if constexpr (std::is_integral_v<std::remove_reference_t<decltype(mean.*member)>>)
    mean.*member = std::lround(sum);
  else
    mean.*member = sum;
}

Phases mean_phases(const std::vector<StudyRun>& runs) {
  std::vector<Phases> phases;
  for (const StudyRun& run : runs) phases.push_back(run.phases);
  Phases mean;
  for (const auto phase :
       {&Phases::detect, &Phases::assemble, &Phases::factor, &Phases::solve, &Phases::update, &Phases::write})
    average(mean, phases, phase);
  return mean;
}

/// Of the same scene all runs have the same effects.
void average_effect(EffectOutcome& mean, std::size_t number, const std::vector<StudyRun>& runs) {
  std::vector<EffectOutcome> effects;
  for (const StudyRun& run : runs)
    if (number < run.effects.size()) effects.push_back(run.effects[number]);
  average(mean, effects, &EffectOutcome::seconds);
  for (const auto count : {&EffectOutcome::built, &EffectOutcome::evaluations, &EffectOutcome::assemblies})
    average(mean, effects, count);
}

}  // namespace

StudyRun mean_run(const std::vector<StudyRun>& repeats) {
  StudyRun mean = repeats.front();
  const auto failed = std::find_if(repeats.begin(), repeats.end(),
                                   [](const StudyRun& run) { return run.status != StudyStatus::completed; });
  if (failed != repeats.end()) {
    mean.status = failed->status;
    mean.reason = failed->reason;
    if (repeats.size() > 1) mean.reason = "repeat " + std::to_string(failed - repeats.begin()) + ": " + mean.reason;
  }
  for (const auto seconds : {&StudyRun::cpu_seconds, &StudyRun::wall_seconds, &StudyRun::mesh_seconds})
    average(mean, repeats, seconds);
  for (const auto count : {&StudyRun::steps, &StudyRun::iterations, &StudyRun::cuts}) average(mean, repeats, count);
  mean.phases = mean_phases(repeats);
  for (std::size_t i = 0; i < mean.effects.size(); ++i) average_effect(mean.effects[i], i, repeats);
  mean.expect.clear();
  mean.moments.clear();
  mean.travel = {};
  return mean;
}

}  // namespace talus
