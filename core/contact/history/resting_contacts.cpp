#include "contact/history/resting_contacts.hpp"

#include <algorithm>

namespace talus {

void RestingContacts::put(const ContactHistory& history) {
  const auto [a, b] = history.bodies;
  std::vector<ContactHistory>& histories = pairs_[{a, b}];
  if (histories.empty()) {
    partners_[a].push_back(b);
    partners_[b].push_back(a);
  }
  histories.push_back(history);
  for (int body : history.bodies) deepest_[body] = std::max(deepest_[body], -history.gap);
  bonded_ += history.bonded;
  spring_energy_ += history.spring_energy;
}

void RestingContacts::take(int body, const std::function<bool(int)>& wakes, std::vector<ContactHistory>& histories) {
  const auto first = std::partition(partners_[body].begin(), partners_[body].end(), [&](int b) { return !wakes(b); });
  const std::vector<int> woken(first, partners_[body].end());
  partners_[body].erase(first, partners_[body].end());
  for (int partner : woken) {
    std::erase(partners_[partner], body);
    const auto pair = pairs_.find(std::minmax(body, partner));
    for (const ContactHistory& history : pair->second) {
      bonded_ -= history.bonded;
      spring_energy_ -= history.spring_energy;
    }
    histories.insert(histories.end(), pair->second.begin(), pair->second.end());
    pairs_.erase(pair);
    measure(partner);
  }
  measure(body);
}

void RestingContacts::measure(int body) {
  deepest_[body] = 0;
  for (int partner : partners_[body]) {
    for (const ContactHistory& history : pairs_.at(std::minmax(body, partner)))
      deepest_[body] = std::max(deepest_[body], -history.gap);
  }
}

void RestingContacts::list(const std::function<bool(int, int)>& are_wanted, std::vector<RestingContact>& rows) const {
  for (const auto& [bodies, histories] : pairs_) {
    if (!are_wanted(bodies.first, bodies.second)) continue;
    for (const ContactHistory& m : histories) {
      rows.push_back({.bodies = {m.bodies[0], m.bodies[1]},
                      .joint = m.joint,
                      .position = m.position,
                      .normal = m.normal,
                      .mode = m.mode,
                      .normal_force = m.normal_force,
                      .shear_force = m.shear,
                      .area = m.area,
                      .friction = m.friction,
                      .cohesion = m.cohesion,
                      .bonded = m.bonded,
                      .broken = m.broken});
    }
  }
}

}  // namespace talus
