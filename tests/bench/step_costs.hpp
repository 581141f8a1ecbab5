#pragma once

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>
#include <string>

#include "solve/simulation.hpp"

namespace talus {

/// What a number of steps of a simulation cost, by phase and by effect, and what they did.
class StepCosts {
 public:
  /// The steps that count begin now.
  explicit StepCosts(const Simulation& simulation)
      : before_(simulation.work()), effects_(seconds_of(simulation)), evaluated_before_(evaluations_of(simulation)) {}

  void take_step(Simulation& simulation) {
    const std::clock_t begin = std::clock();  // processor time: the machine may be busy
    const StepReport report = simulation.step();
    processor_ += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const Phases& p = report.phases;
    const double phases[] = {p.detect, p.assemble, p.factor, p.solve, p.update};
    for (int k = 0; k < 5; ++k) phases_[k] += phases[k];
    iterations_ += report.iterations;
    asleep_ = report.asleep;
    ++steps_;
  }
  void finish(const Simulation& simulation) {
    const RunWork now = simulation.work();
    points_ = now.contact_points - before_.contact_points;
    factorisations_ = now.factorisations - before_.factorisations;
    dense_ = now.dense_factorisations - before_.dense_factorisations;
    gmres_ = now.gmres_iterations - before_.gmres_iterations;
    evaluations_ = evaluations_of(simulation) - evaluated_before_;
    for (auto& [name, seconds] : effects_) seconds = seconds_of(simulation)[name] - seconds;
  }

  /// What was disturbed less, of two measurements of the same steps.
  void take_least(const StepCosts& again) {
    processor_ = std::min(processor_, again.processor_);
    for (int k = 0; k < 5; ++k) phases_[k] = std::min(phases_[k], again.phases_[k]);
    for (auto& [name, seconds] : effects_) seconds = std::min(seconds, again.effects_.at(name));
  }

  double microseconds() const { return a_step(1e6 * processor_); }
  double a_step(double all) const { return all / steps_; }

  static void print_head() {
    std::printf(
        "| scene | µs a step | detect, assemble, factor, solve, update, %% | iterations | evaluations | contact points "
        "| "
        "factorisations, sparse and dense | GMRES | asleep |\n|---|---|---|---|---|---|---|---|---|\n");
  }
  void print(const std::string& name) const {
    std::printf("| %s | %.1f |", name.c_str(), microseconds());
    for (int k = 0; k < 5; ++k) std::printf("%s %.0f", k > 0 ? "," : "", share(phases_[k]));
    std::printf(" | %.2f | %.2f | %.1f | %.2f, %.2f | %.1f | %d |\n", a_step(iterations_), a_step(evaluations_),
                a_step(points_), a_step(factorisations_), a_step(dense_), a_step(gmres_), asleep_);
    std::fflush(stdout);
  }
  /// "inertia 10, normal contact 30": of each effect that is there, % of the step.
  std::string by_effect() const {
    std::string text;
    char part[80];
    for (const auto& [name, seconds] : effects_) {
      if (share(seconds) < 0.5) continue;
      std::snprintf(part, sizeof part, "%s%s %.0f", text.empty() ? "" : ", ", name.c_str(), share(seconds));
      text += part;
    }
    return text;
  }

 private:
  /// Wall time, of that of all phases [%].
  double share(double seconds) const {
    return 100 * seconds / (phases_[0] + phases_[1] + phases_[2] + phases_[3] + phases_[4]);
  }
  static std::map<std::string, double> seconds_of(const Simulation& simulation) {
    std::map<std::string, double> seconds;
    for (const EffectOutcome& effect : simulation.effects()) seconds[effect.name] = effect.seconds;
    return seconds;
  }

  /// How often the force of all effects was evaluated.
  static long evaluations_of(const Simulation& simulation) {
    long most = 0;
    for (const EffectOutcome& effect : simulation.effects()) most = std::max(most, effect.evaluations);
    return most;
  }

  RunWork before_;
  std::map<std::string, double> effects_;
  long evaluated_before_;
  double processor_ = 0, phases_[5] = {};
  long iterations_ = 0, points_ = 0, factorisations_ = 0, dense_ = 0, gmres_ = 0, evaluations_ = 0;
  int steps_ = 0, asleep_ = 0;
};

}  // namespace talus
