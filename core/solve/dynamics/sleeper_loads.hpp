#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "bodies/body_set.hpp"
#include "contact/contact_point.hpp"

namespace talus {

/// What presses on bodies that sleep. Those who are awake may lean and slide on a sleeper: while what they press it
/// with is as it was when it fell asleep, it would go on standing still.
class SleeperLoads {
 public:
  /// `sizes`: of each body, the mesh size [m]. `tolerance`: change of what presses on a sleeper, over all the forces
  /// that it bore when it fell asleep.
  SleeperLoads(std::vector<double> sizes, double tolerance)
      : sizes_(std::move(sizes)),
        tolerance_(tolerance),
        of_all_(sizes_.size()),
        of_awake_(sizes_.size()),
        now_(sizes_.size()),
        is_touched_(sizes_.size(), 0) {}

  /// `sleepers` fall asleep after a step, whose contacts came to `outcomes`.
  void fall_asleep(std::span<const int> sleepers, const BodySet& set, const ContactSet& contacts,
                   std::span<const ContactOutcome> outcomes);
  /// Bodies fell asleep or woke. `resting`: contacts of sleepers with each other and with what is fixed.
  void set_resting(const BodySet& set, const std::vector<RestingContact>& resting);
  /// Sleepers, one flag a body, that `contacts` press otherwise than when they fell asleep. `force`: of the contact of
  /// this number, on its first body [N]. Costs nothing for those whom nobody awake touches.
  std::vector<int> pressed(const BodySet& set, const ContactSet& contacts, const std::vector<char>& asleep,
                           const std::function<Vec3(int contact)>& force);

  void archive(auto& state) { state(of_all_, of_awake_, lean_on_awake_); }

 private:
  struct Load {
    Vec3 force = Vec3::Zero();   // N
    Vec3 moment = Vec3::Zero();  // N m, about the first node of the body
    double pressing = 0;         // N, the sum of the forces however directed: two that squeeze the body count
    Load& operator-=(const Load& other);
    void archive(auto& state) { state(force, moment, pressing); }
  };
  bool differ(int body, const Load& a, const Load& b) const;
  /// Adds a contact's force [N, on its first body] to the loads of those of its two bodies that are `wanted`.
  static void add(std::vector<Load>& loads, const BodySet& set, const auto& contact, const Vec3& force,
                  const auto& wanted);

  std::vector<double> sizes_;
  double tolerance_;
  std::vector<Load> of_all_;        // a sleeper: of all its contacts as it fell asleep, …
  std::vector<Load> of_awake_;      // … of those with bodies that are awake now …
  std::vector<Load> now_;           // … and what these come to, while it is asked
  std::vector<int> lean_on_awake_;  // sleepers that would be pressed otherwise if no contact touched them
  std::vector<int> touched_;        // sleepers that some do, while it is asked
  std::vector<char> is_touched_;
};

}  // namespace talus
