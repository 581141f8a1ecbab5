#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contact/contact_point.hpp"
#include "mesh/surface.hpp"
#include "model/solver_settings.hpp"

namespace talus {

/// One body as contact sees it.
struct ContactBody {
  const Surface* surface = nullptr;  ///< outlives the detector; its node numbers are local
  int first_node = 0;                ///< local node i is global node first_node + i
  bool fixed = false;
  double young = 0;  ///< Pa
};

struct ContactSettings {
  ContactModel model = ContactModel::area;
  double stiffness = 10;     ///< κ: k_n = κ E*/h [Pa/m], 1/E* = 1/E1 + 1/E2
  double shear_ratio = 0.4;  ///< k_s / k_n
  double facing_angle = 3;   ///< degrees within which two facets face each other
  double depth = 0.3;        ///< of h: deeper than this is not a contact of this facet
};

/// Finds the contact points of all bodies (METHOD §3) and remembers them from step to step.
class ContactDetector {
 public:
  /// `laws`: one a joint. `pair_joint(a, b)`: the joint of two bodies' facets that lie on no common joint plane.
  ContactDetector(std::vector<ContactBody> bodies, std::vector<JointLaw> laws, std::vector<std::vector<int>> pair_joint,
                  ContactSettings settings);
  ~ContactDetector();

  /// Contact points at the positions x [m] (all bodies' nodes), for gaps up to `reach` [m]; bonded points also beyond
  /// it. The order is that of the keys. Points remember shear force, multiplier, slip, bond and mode by key, or
  /// from the former points that they go on from (docs/contact.md, "Memory"). Until a step is accepted in which one of
  /// the two bodies could move, their facing points that touch are bonded if the joint has cohesion or tension. May be
  /// called again with other positions before accept(): nothing is remembered but by that.
  void detect(std::span<const Vec3> x, double reach, ContactSet& contacts);

  /// Pairs of nodes (i < j, of movable bodies; also of one body, where corners merge) that the contacts couple or may
  /// soon: the sparse pattern is planned for them. Sorted.
  const std::vector<std::pair<int, int>>& coupled_nodes() const;

  /// Counts the changes of coupled_nodes(): while it stays the same, so does the pattern.
  std::uint64_t coupling_generation() const;

  /// Takes the outcomes of an accepted step, one for each point of `contacts`, which must be what detect() gave last,
  /// with the modes of the last iterate. Throws std::logic_error if their numbers differ.
  void accept(const ContactSet& contacts, std::span<const ContactOutcome> outcomes);

  /// Strength changed between stages.
  void set_laws(std::vector<JointLaw> laws);

  /// Bodies are held or released between stages: `fixed` has an entry a body; throws std::logic_error if it has not.
  /// Two held bodies make no contacts, and theirs are remembered until one is released; what a pair's size and
  /// stiffness are measured by changes, and so does the plan of coupled_nodes().
  void set_fixed(const std::vector<bool>& fixed);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace talus
