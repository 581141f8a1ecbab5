#include "contact/resting_contacts.hpp"

#include <algorithm>

namespace talus {

void RestingContacts::put(const ContactMemo& memo) {
  const auto [a, b] = memo.bodies;
  std::vector<ContactMemo>& memos = pairs_[{a, b}];
  if (memos.empty()) {
    partners_[a].push_back(b);
    partners_[b].push_back(a);
  }
  memos.push_back(memo);
  for (int body : memo.bodies) deepest_[body] = std::max(deepest_[body], -memo.gap);
  bonded_ += memo.bonded;
}

void RestingContacts::take(int body, const std::function<bool(int)>& wakes, std::vector<ContactMemo>& memos) {
  const auto first = std::partition(partners_[body].begin(), partners_[body].end(), [&](int b) { return !wakes(b); });
  const std::vector<int> woken(first, partners_[body].end());
  partners_[body].erase(first, partners_[body].end());
  for (int partner : woken) {
    std::erase(partners_[partner], body);
    const auto pair = pairs_.find(std::minmax(body, partner));
    for (const ContactMemo& memo : pair->second) bonded_ -= memo.bonded;
    memos.insert(memos.end(), pair->second.begin(), pair->second.end());
    pairs_.erase(pair);
    measure(partner);
  }
  measure(body);
}

void RestingContacts::measure(int body) {
  deepest_[body] = 0;
  for (int partner : partners_[body]) {
    for (const ContactMemo& memo : pairs_.at(std::minmax(body, partner)))
      deepest_[body] = std::max(deepest_[body], -memo.gap);
  }
}

void RestingContacts::list(const std::function<bool(int, int)>& are_wanted, std::vector<RestingContact>& rows) const {
  for (const auto& [bodies, memos] : pairs_) {
    if (!are_wanted(bodies.first, bodies.second)) continue;
    for (const ContactMemo& m : memos) {
      rows.push_back(
          {{m.bodies[0], m.bodies[1]}, m.joint, m.position, m.normal, m.mode, m.normal_force, m.shear, m.area});
    }
  }
}

}  // namespace talus
