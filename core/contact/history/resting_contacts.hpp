#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "contact/contact_point.hpp"

namespace talus {

/// What a contact remembers from one accepted step to the next. Shear is kept as force and area, so that a corner whose
/// part of the area changes keeps its traction: no anchor points, hence no jumps when corners merge.
struct ContactHistory {
  std::uint64_t key, family;
  std::array<int, 2> bodies;
  int joint;
  Vec3 position, normal, shear;
  double gap, size, area;
  double normal_force, multiplier;
  double spring_energy;  ///< J, at the end of the step …
  double shear_energy;   ///< J, … and what of it shear holds
  double slip, initial_interference, penalty_scaling;
  double friction, cohesion;  ///< as ContactPoint's
  ContactMode mode;
  bool bonded, broken;
  bool continues;  ///< a point of this step has its key

  void archive(auto& state) {
    state(key, family, bodies, joint, position, normal, shear, gap, size, area, normal_force, multiplier);
    state(spring_energy, shear_energy, slip, initial_interference, penalty_scaling, friction, cohesion);
    state(mode, bonded, broken, continues);
  }
};

/// Histories of pairs of bodies at rest, put aside until one of the two moves again.
class RestingContacts {
 public:
  explicit RestingContacts(std::size_t bodies) : partners_(bodies), deepest_(bodies, 0.0) {}

  void put(const ContactHistory& history);
  /// Appends the histories of the body's pairs with partners that `wakes`, and forgets them here.
  void take(int body, const std::function<bool(int partner)>& wakes, std::vector<ContactHistory>& histories);

  /// How deep the body lies in those that it rests with. [m]
  double deepest(int body) const { return deepest_[body]; }
  bool any_bonded() const { return bonded_ > 0; }
  double spring_energy() const { return spring_energy_; }  ///< J, of all
  /// Calls `look` with what is remembered of the body's contacts.
  template <class Look>
  void visit(int body, const Look& look) const {
    for (const int partner : partners_[body])
      for (const ContactHistory& history : pairs_.at(std::minmax(body, partner))) look(history);
  }

  /// Appends what is remembered of pairs that `are_wanted`, sorted by bodies and then by keys.
  void list(const std::function<bool(int body_a, int body_b)>& are_wanted, std::vector<RestingContact>& rows) const;

  void archive(auto& state) { state(pairs_, partners_, deepest_, bonded_, spring_energy_); }

 private:
  void measure(int body);

  std::map<std::pair<int, int>, std::vector<ContactHistory>> pairs_;
  std::vector<std::vector<int>> partners_;  // a body
  std::vector<double> deepest_;             // a body
  int bonded_ = 0;
  double spring_energy_ = 0;  ///< J
};

}  // namespace talus
