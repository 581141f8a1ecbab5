#pragma once

#include "effects/compose.hpp"
#include "results/run_report.hpp"
#include "solve/dynamics/impacts.hpp"

namespace talus {

/// Keeps the energy ledger of a run [J]. The forces of all effects balance in a step, so their works Σ ∇Π_e·D over the
/// free nodes cancel; what an effect's work is more than the energy it then holds and has dissipated, time integration
/// has eaten.
class EnergyBalance {
 public:
  /// The effects of a stage, before its first step.
  void begin_stage(const Composition& composition);
  /// Effects were put into the composition of the stage; they hold nothing yet.
  void put_in(const Composition& composition, const PutIn& where);
  /// Velocities were given from outside: their energy is new.
  void energy_was_given(const Composition& composition);
  /// So were accelerations, for which time integration holds `reserve` now [J].
  void accelerations_were_given(double reserve);
  /// Bodies fell asleep or woke: what effects hold from now on is of those that are awake, and `ledger` keeps the rest.
  /// What was left of the motion of those that fell asleep is lost. Of contacts after_step() is told.
  void awake_changed(const Composition& composition);
  /// After effects have accepted D and bodies have moved. `works`: ∇Π_e·D over free nodes, an effect; `by_impacts`:
  /// what impacts did to the energy at the end of the step; `springs_at_rest`: what springs between bodies hold that
  /// both rest; `reserve`: what time integration holds, and will give back [J].
  const EnergyLedger& after_step(const Composition& composition, const std::vector<double>& works, const Increment& d,
                                 const ImpactEnergy& by_impacts, double springs_at_rest, double reserve);
  const EnergyLedger& ledger() const { return ledger_; }  ///< as of the last step

  /// What it remembers from step to step.
  void archive(auto& state) { state(ledger_, entries_, given_, reserve_, reserve_of_given_, springs_at_rest_); }

 private:
  struct Entry {
    EffectKind kind;
    double stored = 0;  ///< J

    void archive(auto& state) { state(stored); }
  };
  double& column(EnergyAccount account);
  EnergyLedger ledger_;
  std::vector<Entry> entries_;                 ///< one an effect of the stage
  double given_ = 0;                           ///< J, with the start and with velocities
  double reserve_ = 0, reserve_of_given_ = 0;  ///< J, now, and what came with accelerations that were given
  double springs_at_rest_ = 0;                 ///< J, after the last step
};

}  // namespace talus
