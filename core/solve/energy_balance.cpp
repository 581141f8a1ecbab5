#include "solve/energy_balance.hpp"

#include <algorithm>

namespace talus {

double& EnergyBalance::column(EnergyAccount account) {
  switch (account) {
    case EnergyAccount::kinetic:
      return ledger_.kinetic;
    case EnergyAccount::elastic:
      return ledger_.elastic;
    case EnergyAccount::potential:
      return ledger_.potential;
    default:
      return ledger_.contact;
  }
}

void EnergyBalance::begin_stage(const Composition& composition) {
  const std::vector<Entry> before = std::move(entries_);
  entries_.clear();
  for (const auto& effect : composition.effects) {
    const auto same =
        std::find_if(before.begin(), before.end(), [&](const Entry& e) { return e.kind == effect->kind(); });
    Entry entry{effect->kind(), effect->stored_energy()};
    if (before.empty()) {
      column(effect->account()) += entry.stored;
      given_ += entry.stored;
    } else if (same != before.end() && effect->account() == EnergyAccount::contact) {
      entry.stored = same->stored;  // springs go on from one stage to the next
    } else if (same != before.end() && effect->kind() != EffectKind::point_load) {
      column(effect->account()) += entry.stored - same->stored;  // of blocks that are held from now on, or let go
      ledger_.integration_loss -= entry.stored - same->stored;
    }
    entries_.push_back(entry);
  }
}

void EnergyBalance::put_in(const Composition& composition, const PutIn& where) {
  for (int i = where.place; i < where.place + where.count; ++i)
    entries_.insert(entries_.begin() + i, {composition.effects[i]->kind(), 0});
}

void EnergyBalance::energy_was_given(const Composition& composition) {
  for (std::size_t i = 0; i < composition.effects.size(); ++i) {
    const double change = composition.effects[i]->stored_energy() - entries_[i].stored;
    if (composition.effects[i]->account() != EnergyAccount::kinetic) continue;
    ledger_.kinetic += change;
    given_ += change;
    entries_[i].stored += change;
  }
}

void EnergyBalance::accelerations_were_given(double reserve) {
  reserve_of_given_ += reserve - reserve_;
  reserve_ = reserve;
}

void EnergyBalance::awake_changed(const Composition& composition) {
  for (std::size_t i = 0; i < composition.effects.size(); ++i) {
    const Effect& effect = *composition.effects[i];
    if (effect.account() == EnergyAccount::contact) continue;  // as after_step is told of springs at rest
    const double change = effect.stored_energy() - entries_[i].stored;
    entries_[i].stored += change;
    if (effect.account() != EnergyAccount::kinetic) continue;
    ledger_.kinetic += change;
    ledger_.integration_loss -= change;
  }
}

const EnergyLedger& EnergyBalance::after_step(const Composition& composition, const std::vector<double>& works,
                                              const Increment& d, const ImpactEnergy& by_impacts,
                                              double springs_at_rest, double reserve) {
  ledger_.damping_dissipated += by_impacts.taken;
  ledger_.constraint_work += by_impacts.by_driven;
  ledger_.contact += springs_at_rest - springs_at_rest_;
  ledger_.integration_loss -= by_impacts.taken - by_impacts.by_driven + springs_at_rest - springs_at_rest_;
  springs_at_rest_ = springs_at_rest;
  reserve_ = reserve;
  ledger_.integration_reserve = reserve_ - reserve_of_given_;
  for (std::size_t i = 0; i < composition.effects.size(); ++i) {
    const Effect& effect = *composition.effects[i];
    if (effect.account() == EnergyAccount::constraint) {
      ledger_.constraint_work -= works[i];
      continue;
    }
    const double by_held = effect.work_on_held(d), dissipated = effect.dissipated(d);
    const double change = effect.stored_energy() - entries_[i].stored;
    entries_[i].stored += change;
    column(effect.account()) += change;
    (effect.account() == EnergyAccount::damping ? ledger_.damping_dissipated : ledger_.friction_dissipated) +=
        dissipated;
    ledger_.constraint_work += by_held;
    ledger_.integration_loss += works[i] + by_held - change - dissipated;
  }
  ledger_.remainder = ledger_.kinetic + ledger_.elastic + ledger_.potential + ledger_.contact +
                      ledger_.friction_dissipated + ledger_.damping_dissipated + ledger_.integration_loss -
                      ledger_.constraint_work - given_;
  return ledger_;
}

}  // namespace talus
