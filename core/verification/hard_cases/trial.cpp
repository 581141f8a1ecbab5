#include "verification/hard_cases/trial.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "base/hash.hpp"
#include "base/parallel.hpp"
#include "base/part_of_progress.hpp"
#include "base/state_archive.hpp"
#include "base/stopwatch.hpp"
#include "model/number_text.hpp"
#include "verification/hard_cases/interpenetration.hpp"
#include "verification/known_answers/support/ledger_watch.hpp"

namespace talus {

namespace {

/// A run is sampled this often at least, and blocks are looked at for lying in each other this often.
constexpr int fewest_samples = 200, interpenetration_looks = 20;
/// A repetition is taken up anew so often from what was written of it, as a run is that was broken off.
constexpr long times_taken_up = 25;
/// Nor goes any node farther between two samples than this share of the size of the smallest movable block.
constexpr double unseen_distance = 0.25;

std::uint64_t hash_of(const std::vector<Vec3>& positions) {
  std::uint64_t hash = hash_of_nothing;
  for (const Vec3& position : positions)
    for (int k = 0; k < 3; ++k) hash = hash_with(hash, std::bit_cast<std::uint64_t>(position[k]));
  return hash;
}

double smallest_size(const BlockSystem& system) {
  double size = std::numeric_limits<double>::infinity();
  for (const Block& block : system.blocks)
    if (block.body != BodyKind::fixed) size = std::min(size, std::cbrt(block.volume));
  return size;
}

double edge_volume(const std::vector<Vec3>& at, const std::array<int, 4>& nodes) {
  Mat3 edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = at[nodes[i + 1]] - at[nodes[0]];
  return edges.determinant();
}

bool all_finite(const EnergyLedger& e) {
  return std::isfinite(e.kinetic + e.elastic + e.potential + e.contact + e.friction_dissipated + e.damping_dissipated +
                       e.constraint_work + e.integration_loss + e.integration_reserve);
}

/// How often a run goes on from what was written of it.
enum class Interrupted { never, many_times };

/// One run, measured step by step.
class TrialRun {
 public:
  TrialRun(const CaseScene& scene, bool keeps_nodes, const Tolerances& tolerances, Interrupted interrupted,
           Trial& trial)
      : scene_(scene),
        keeps_nodes_(keeps_nodes),
        tolerances_(tolerances),
        trial_(trial),
        simulation_(std::make_unique<Simulation>(scene.project, scene.system, tolerances)),
        ledger_(scene),
        interpenetration_(scene.system),
        trajectory_{scene.system, {}, {}},
        unseen_(unseen_distance * smallest_size(scene.system)),
        steps_a_sample_(std::max(1L, simulation_->total_steps() / fewest_samples)),
        steps_a_look_(std::max(1L, simulation_->total_steps() / interpenetration_looks)),
        steps_till_written_(interrupted == Interrupted::never
                                ? std::numeric_limits<long>::max()
                                : std::max(1L, simulation_->total_steps() / times_taken_up)) {}

  void run(Progress& progress) {
    sample(-1);
    look_for_interpenetration();
    while (!simulation_->finished()) {
      if (progress.cancelled()) throw Cancelled{};
      if ((trial_.steps + 1) % steps_till_written_ == 0) take_up_anew();
      const StepReport report = simulation_->step();
      measure(report);
      if (!simulation_->converged()) return fail(TrialEnding::not_converged, simulation_->failure());
      if (!trial_.finite) return fail(TrialEnding::broken_off, "a position, velocity or energy is not a number");
      progress.report(simulation_->time() / simulation_->end_time(), {});
    }
  }

  const Trajectory& trajectory() const { return trajectory_; }

 private:
  void fail(TrialEnding ending, const std::string& reason) {
    trial_.ending = ending;
    trial_.reason = reason;
  }

  void take_up_anew() {
    StateArchive written;
    simulation_->archive(written);
    simulation_ = std::make_unique<Simulation>(scene_.project, scene_.system, tolerances_);
    StateArchive read(written.bytes());
    simulation_->archive(read);
  }

  void measure(const StepReport& report) {
    ++trial_.steps;
    trial_.iterations += report.iterations;
    trial_.most_iterations = std::max(trial_.most_iterations, report.iterations);
    trial_.cuts += report.cuts;
    if (!simulation_->converged()) return;
    trial_.penetration = std::max(trial_.penetration, report.max_relative_penetration);
    trial_.least_volume = std::min(trial_.least_volume, least_volume_ratio(simulation_->bodies()));
    trial_.finite = all_finite(simulation_->bodies()) && all_finite(report.energy);
    measure_energy(report);
    distance_ += report.max_displacement;
    const bool last = simulation_->stage_ended();
    if (last || distance_ > unseen_ || trial_.steps % steps_a_sample_ == 0) sample(report.stage);
    if (last || trial_.steps % steps_a_look_ == 0) look_for_interpenetration();
  }

  void measure_energy(const StepReport& report) {
    if (report.stage != stage_ && !scene_.project.stages[report.stage].blocks.empty()) ledger_.holds_change();
    stage_ = report.stage;
    ledger_.look(report.energy);
    const double moved = std::max(ledger_.moved(), std::numeric_limits<double>::min());
    trial_.energy_growth = ledger_.growth() / moved;
    trial_.remainder = std::abs(ledger_.remainder()) / moved;
    trial_.grows = ledger_.grows(most_energy_growth);
    trial_.closes = ledger_.closes();
  }

  void sample(int stage) {
    Snapshot snapshot{simulation_->time(), stage, {}};
    for (std::size_t b = 0; b < scene_.system.blocks.size(); ++b)
      snapshot.blocks.push_back(block_motion(simulation_->bodies(), static_cast<int>(b)));
    trajectory_.snapshots.push_back(std::move(snapshot));
    if (keeps_nodes_) keep_nodes();
    trial_.prints.push_back({simulation_->time(), trial_.iterations, hash_of(simulation_->bodies().nodes.position)});
    distance_ = 0;
  }

  void keep_nodes() {
    const NodeSet& nodes = simulation_->bodies().nodes;
    trajectory_.nodes.push_back({{nodes.position.begin(), nodes.position.begin() + nodes.of_blocks},
                                 {nodes.velocity.begin(), nodes.velocity.begin() + nodes.of_blocks}});
  }

  void look_for_interpenetration() {
    const Interpenetration found = interpenetration_.deepest(simulation_->bodies(), trial_.interpenetration);
    if (found.depth <= trial_.interpenetration) return;
    trial_.interpenetration = found.depth;
    trial_.interpenetrating = scene_.system.blocks[found.block].name + " in " + scene_.system.blocks[found.into].name;
  }

  const CaseScene& scene_;
  const bool keeps_nodes_;
  const Tolerances& tolerances_;
  Trial& trial_;
  std::unique_ptr<Simulation> simulation_;
  LedgerWatch ledger_;
  InterpenetrationCheck interpenetration_;
  Trajectory trajectory_;
  double unseen_, distance_ = 0;  // m, since the last sample
  long steps_a_sample_, steps_a_look_, steps_till_written_;
  int stage_ = 0;
};

std::vector<Fault> unmet_expectations(const HardCase& scene, const Trajectory& trajectory) {
  std::vector<Fault> unmet;
  for (const HardCaseExpectation& expectation : scene.expected)
    if (const std::string fault = expectation.fault(trajectory); !fault.empty())
      unmet.push_back({expectation.kind, "expected: " + expectation.words + "; but " + fault});
  return unmet;
}

/// One run of the scene, as it was asked for.
Trial single_run(const HardCase& scene, int threads, Interrupted interrupted, const TrialOptions& options,
                 Progress& progress) {
  Trial trial;
  trial.name = scene.name;
  trial.known_shortfall = scene.shortfall;
  trial.group = scene.group;
  trial.title = scene.title;
  trial.source = scene.source;
  trial.threads = threads;
  for (const HardCaseExpectation& expectation : scene.expected) trial.expected.push_back(expectation.words);
  const Stopwatch watch(trial.seconds);
  const ThreadLimit limit(threads);
  try {
    CaseScene built = scene.build();
    double& tolerance = built.project.solver.tolerance;
    if (tolerance == SolverSettings{}.tolerance) tolerance = options.tolerance.value_or(tolerance);
    TrialRun run(built, scene.keeps_nodes, options.tolerances, interrupted, trial);
    run.run(progress);
    for (const BlockMotion& block : run.trajectory().last().blocks) trial.displacements.push_back(block.displacement);
    if (trial.ending == TrialEnding::completed) trial.unmet = unmet_expectations(scene, run.trajectory());
  } catch (const std::exception& error) {
    trial.ending = TrialEnding::broken_off;
    trial.reason = error.what();
  }
  return trial;
}

/// What is not seen in positions.
std::array<std::uint64_t, 6> figures(const Trial& trial) {
  return {std::bit_cast<std::uint64_t>(trial.energy_growth), std::bit_cast<std::uint64_t>(trial.remainder),
          std::bit_cast<std::uint64_t>(trial.penetration),   std::bit_cast<std::uint64_t>(trial.least_volume),
          static_cast<std::uint64_t>(trial.most_iterations), static_cast<std::uint64_t>(trial.cuts)};
}

std::string difference(const Trial& a, const Trial& b) {
  if (a.ending != b.ending || a.reason != b.reason)
    return "it ended otherwise: " + std::string(to_string(b.ending)) + (b.reason.empty() ? "" : ", " + b.reason);
  const auto [mine, others] = std::mismatch(a.prints.begin(), a.prints.end(), b.prints.begin(), b.prints.end());
  if (mine != a.prints.end() || others != b.prints.end()) {
    const double time = mine != a.prints.end() ? mine->time : others->time;
    return "positions or iterations differ at t = " + significant(time) + " s";
  }
  if (figures(a) != figures(b)) return "energies, penetration or cuts differ";
  return {};
}

/// Runs the scene at the other place and, of the same shapes, at home.
TrialElsewhere run_elsewhere(const HardCase& scene, const TrialOptions& options, Progress& progress) {
  const Elsewhere& place = *scene.elsewhere;
  HardCase there = scene, home = scene;
  there.expected.clear(), home.expected.clear();
  there.build = [&] { return moved_elsewhere(scene.build(), place); };
  home.build = [&] { return brought_home(there.build(), place); };
  PartOfProgress first(progress, 0, 0.5, "elsewhere"), second(progress, 0.5, 0.5, "at home");
  const Trial far = single_run(there, options.threads, Interrupted::never, options, first);
  const Trial near = single_run(home, options.threads, Interrupted::never, options, second);
  if (far.ending != near.ending || far.displacements.size() != near.displacements.size())
    return {0, "it ended otherwise: " + std::string(to_string(far.ending)) + ", at home " +
                   std::string(to_string(near.ending))};
  const double apart = most_apart(near.displacements, far.displacements, place) / extent_of_what_moves(scene.build());
  if (apart <= most_apart_elsewhere) return {apart, {}};
  return {apart, "displacements differ by " + significant(apart) + " of the size"};
}

}  // namespace

std::uint64_t fingerprint(const Trial& trial) {
  std::uint64_t hash = hash_of_nothing;
  for (const SnapshotHash& snapshot : trial.prints) {
    hash = hash_with(hash, std::bit_cast<std::uint64_t>(snapshot.time));
    hash = hash_with(hash, static_cast<std::uint64_t>(snapshot.iterations));
    hash = hash_with(hash, snapshot.positions);
  }
  return hash;
}

bool Trial::passed() const { return faults(*this).empty(); }

std::vector<Fault> faults_by_kind(const Trial& trial) {
  std::vector<Fault> list;
  const auto hold = [&list](bool held, FaultKind kind, const std::string& words) {
    if (!held) list.push_back({kind, words});
  };
  hold(trial.ending != TrialEnding::not_converged, FaultKind::not_converged, "did not converge: " + trial.reason);
  hold(trial.ending != TrialEnding::broken_off, FaultKind::broken_off, "broke off: " + trial.reason);
  hold(trial.finite, FaultKind::not_finite, "a position, velocity or energy is not a number");
  hold(trial.penetration < most_penetration, FaultKind::penetration,
       "contacts are " + significant(trial.penetration) + " of the mesh size deep");
  hold(trial.interpenetration < most_penetration, FaultKind::interpenetration,
       trial.interpenetrating + " is " + significant(trial.interpenetration) + " of the mesh size deep");
  hold(!trial.grows, FaultKind::energy, "energy grows by " + significant(trial.energy_growth) + " of what moved");
  hold(trial.closes, FaultKind::ledger, "the energy ledger misses " + significant(trial.remainder) + " of what moved");
  hold(trial.least_volume > 0, FaultKind::inverted,
       "a tetrahedron is inverted: " + significant(trial.least_volume) + " of its volume is left");
  list.insert(list.end(), trial.unmet.begin(), trial.unmet.end());
  for (const TrialRepetition& again : trial.repetitions)
    hold(again.difference.empty(), FaultKind::other_bits,
         "not the same bits on " + std::to_string(again.threads) +
             " threads, taken up anew in between: " + again.difference);
  hold(!trial.elsewhere || trial.elsewhere->difference.empty(), FaultKind::other_place,
       "not the same at another place: " + (trial.elsewhere ? trial.elsewhere->difference : std::string()));
  return list;
}

std::vector<std::string> faults(const Trial& trial) {
  std::vector<std::string> words;
  for (const Fault& fault : faults_by_kind(trial)) words.push_back(fault.words);
  return words;
}

Trial run_trial(const HardCase& scene, const TrialOptions& options, Progress& progress) {
  const bool goes_elsewhere = options.elsewhere && scene.elsewhere;
  const double share = 1 / (1 + static_cast<double>(options.repeat_on.size()) + (goes_elsewhere ? 2 : 0));
  PartOfProgress first(progress, 0, share, "");
  Trial trial = single_run(scene, options.threads, Interrupted::never, options, first);
  for (const int threads : options.repeat_on) {
    PartOfProgress next(progress, share * static_cast<double>(1 + trial.repetitions.size()), share, "again");
    const Trial again = single_run(scene, threads, Interrupted::many_times, options, next);
    trial.repetitions.push_back({threads, difference(trial, again)});
  }
  if (goes_elsewhere) {
    PartOfProgress last(progress, 1 - 2 * share, 2 * share, "elsewhere");
    trial.elsewhere = run_elsewhere(scene, options, last);
  }
  return trial;
}

double least_volume_ratio(const BodySet& bodies) {
  double least = 1;
  for (const Element& element : bodies.elements)
    least = std::min(
        least, edge_volume(bodies.nodes.position, element.nodes) / edge_volume(bodies.nodes.reference, element.nodes));
  return least;
}

bool all_finite(const BodySet& bodies) {
  const auto finite = [](const Vec3& value) { return value.allFinite(); };
  return std::all_of(bodies.nodes.position.begin(), bodies.nodes.position.end(), finite) &&
         std::all_of(bodies.nodes.velocity.begin(), bodies.nodes.velocity.end(), finite);
}

}  // namespace talus
