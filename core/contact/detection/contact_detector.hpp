#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/vector.hpp"
#include "contact/contact_body.hpp"
#include "contact/contact_point.hpp"
#include "contact/contact_settings.hpp"
#include "contact/contact_work.hpp"
#include "contact/pair_joints.hpp"
#include "contact/reach.hpp"

namespace talus {

class StateArchive;

/// Finds the contact points of all bodies and remembers them from step to step (docs/contact.md).
class ContactDetector {
 public:
  /// `laws`: one a joint.
  ContactDetector(std::vector<ContactBody> bodies, std::vector<JointLaw> laws, PairJoints pair_joints,
                  ContactSettings settings);
  ~ContactDetector();

  /// Contact points at the positions x [m] (all bodies' nodes), for gaps up to `reach` [m]; bonded points also over
  /// wider ones. The order is that of the keys. Points remember shear force, multiplier, slip, bond and mode by key, or
  /// from the former points that they go on from (docs/contact.md, "Memory"). Until a step is accepted in which one of
  /// the two bodies could move, their face–face points that touch are bonded if the joint has cohesion or tension. May
  /// be called again with other positions before accept(): nothing is remembered but by that.
  /// What this costs follows what moves: bodies that are apart are not looked at until they may have come near.
  void detect(std::span<const Vec3> x, const Reach& reach, ContactSet& contacts);

  /// The normal of a contact once its features have turned.
  struct UpdatedNormal {
    Vec3 normal;
    double gap;  ///< m, along that normal at the end; the initial interference is in it
  };
  /// Of a point of what detect() gave last, found with nodes at `start` [m], when they will be at `end` [m].
  UpdatedNormal updated_normal(int point, std::span<const Vec3> start, std::span<const Vec3> end) const;

  /// A contact that detect() did not give: as its features stand at the start, none could touch there, or did so in
  /// another place.
  struct MissedContact {
    int bodies[2];
    Vec3 position;    ///< m, on the first body
    double depth;     ///< of the mesh size
    double approach;  ///< of the mesh size: by so much the two came nearer there, against the normal
    double size;      ///< m, the mesh size
    int number;       ///< of the contact among those at the end
    int given;        ///< which of those that detect() gave is that of the same features; −1: none
  };
  /// Contacts deeper than `tolerance` of their mesh size once the nodes have gone from `start` to `end` [m], those that
  /// detect() gave last among them, of two bodies of which one rotates by as much, or which went farther against each
  /// other than detect() was told to reach: `reach` is of the ways that they went. Vertex–vertex contacts are not
  /// looked for, nor is anything in the facet-wise model. Motion must be told of before, with settings for that, and
  /// again if the nodes go back.
  std::span<const MissedContact> missed_contacts(std::span<const Vec3> start, std::span<const Vec3> end,
                                                 const Reach& reach, double tolerance);

  /// Takes contacts that missed_contacts() gave last into `contacts`, which are those that detect() gave: with the
  /// normals that they have at the end, and the gaps along these at `start` [m], however wide. A step that converges
  /// with them is as exact there as its end. What `contacts` learned since detect() is forgotten.
  void take_in(std::span<const MissedContact> missed, std::span<const Vec3> start, ContactSet& contacts);

  /// No node of the body moved by more than `displacement` [m] since this was said last, or since the start: for
  /// settings with `motion_told`, once for every body that moved at all before detect() sees its new positions. Fixed
  /// bodies may move too (prescribed motion).
  void moved(int body, double displacement);

  /// Pairs of nodes (i < j, of bodies that are neither fixed nor asleep; also of one body, where corners merge) that
  /// the contacts couple or may soon: the sparse pattern is planned for them. Sorted. All nodes of a single body (rigid
  /// or affine) are meant by its first, its handle: no pair lies within such a body.
  const std::vector<std::pair<int, int>>& coupled_nodes() const;

  /// Counts the changes of coupled_nodes(): while it stays the same, so does the pattern.
  std::uint64_t coupling_generation() const;

  /// Takes the outcomes of an accepted step, one for each point of `contacts`, which must be what detect() gave last,
  /// with the modes of the last iterate. Throws std::logic_error if their numbers differ, or if bodies were held,
  /// released, put to sleep or woken since.
  void accept(const ContactSet& contacts, std::span<const ContactOutcome> outcomes);

  /// Strength changed between stages.
  void set_laws(std::vector<JointLaw> laws);

  /// Bodies are held or released between stages: `fixed` has an entry a body; throws std::logic_error if it has not.
  /// Two held bodies make no contacts, and theirs are remembered until one is released; what a pair's size and
  /// stiffness are measured by changes, and so does the plan of coupled_nodes().
  void set_fixed(const std::vector<bool>& fixed);

  /// Bodies fall asleep or wake: `asleep` has an entry a body; throws std::logic_error if it has not. A body that is
  /// asleep does not move. Two of them, or one and a fixed one, make no contacts and cost nothing; what their contacts
  /// remember goes on, when one of the two wakes, as if they had been awake. A sleeper and a body that is awake have
  /// contacts as usual. To be called when something changes, between accept() and detect() or to detect anew.
  void set_asleep(const std::vector<char>& asleep);

  /// Contacts of bodies that are at rest, one of them asleep: those that detect() does not give. Sorted by bodies.
  std::vector<RestingContact> resting() const;
  double spring_energy_at_rest() const;  ///< J, of contacts of bodies that both rest, as of their last step

  /// What it remembers from step to step, with the same bodies fixed and asleep. Bodies are where they were.
  void archive(StateArchive& state);

  /// What has been looked at so far, in all.
  const ContactWork& work() const;

  const ContactTolerances& tolerances() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace talus
