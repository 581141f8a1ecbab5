#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/units.hpp"
#include "contact/found_point.hpp"
#include "contact/history/resting_contacts.hpp"
#include "contact/points_by_bodies.hpp"
#include "model/tolerances.hpp"

namespace talus {

/// The histories of contacts, from one accepted step to the next, and which points go on from which. Those of two
/// bodies at rest are put aside and cost nothing.
class ContactMemory {
 public:
  /// The history that a point goes on from: of one former contact, or the forces of several added up.
  struct TransferredHistory {
    Vec3 shear = Vec3::Zero();          ///< N on the first body, in the point's plane
    double spring_force = 0;            ///< N, compression beside the multiplier
    double spring_energy = 0;           ///< J, of that
    double shear_energy = 0;            ///< J
    double multiplier = 0;              ///< N
    double slip, initial_interference;  ///< m, as ContactPoint's
    double penalty_scaling;             ///< as ContactPoint's
    ContactMode mode;
    bool bonded;
    bool same_spring;  ///< the contact of this key, and no face–face contact of which only a vertex or an edge is left
  };

  /// `by_key_alone`: the facet-wise model knows nothing of the features around.
  ContactMemory(std::size_t bodies, bool by_key_alone, const ContactTolerances& tolerances)
      : by_key_alone_(by_key_alone),
        tolerances_(tolerances),
        flush_cosine_(std::cos(radians(tolerances.flush_angle))),
        resting_(bodies),
        of_body_begin_(bodies + 1, 0),
        holds_begin_(bodies + 1, 0) {}

  /// Must precede transferred_to(), and the points stay until then: gives every former contact to the one with its key.
  /// The force of one that lost its key is transferred, once: of a face–face contact to nobody while the same smooth
  /// faces are in face–face contact, for then their traction is taken up by the corners there; else, as of vertices and
  /// edges, to the nearest point of the same smooth faces or sharp edges, or of the same bodies close by. `points` are
  /// sorted by key.
  void transfer(std::span<const FoundPoint> points);

  /// The history of the former contact with the key of the point of this number, and the forces transferred to it. A
  /// new face–face point takes the traction of the nearest former one of the same smooth faces. Forces keep their
  /// length as they turn into the point's plane. Nothing where the point is really new. `size`: its mesh size [m].
  std::optional<TransferredHistory> transferred_to(int point, double size) const;

  /// The former contact with the key of the point of this number; null where there was none.
  const ContactHistory* own(int point) const { return own_[point] < 0 ? nullptr : &histories_[own_[point]]; }
  /// Former contacts of these two bodies, in the order that a point has them in.
  void visit_between(const std::array<int, 2>& bodies, const std::function<void(const ContactHistory&)>& look) const;

  /// Whether the contact with this key was closed or bonded when the last step was accepted.
  bool remembers(std::uint64_t key) const { return with_key(key) != nullptr; }

  /// How deep the body lay, when the last step was accepted, in those that pushed it along `direction`, other than
  /// `but` (−1: nobody); 0 where none did. [m]
  double depth_along(int body, const Vec3& direction, int but = -1) const;
  /// How deep the two lay in each other when the last step was accepted, what was in when they were found included. [m]
  double depth_between(int body_a, int body_b) const;
  /// How far a spring of this stiffness [N/m] may give at a point from the beginning, and neither push harder nor hold
  /// more than one did between the same bodies, along this normal or nearly so, when the last step was accepted. [m]
  double known_compression(const FoundPoint& point, double stiffness) const;

  /// Whether a bond between these two smooth faces ever broke.
  bool ever_broken(std::uint64_t family) const;
  bool any_broken() const { return !broken_.empty(); }
  bool any_bonded() const { return any_bonded_ || resting_.any_bonded(); }

  /// Replaces everything by the outcomes of a step, but for contacts of bodies that both rest: they are not looked for.
  /// Contacts that are open and not bonded are forgotten. `families` belong to the points, which are sorted by key.
  void accept(const ContactSet& contacts, std::span<const std::uint64_t> families,
              std::span<const ContactOutcome> outcomes);

  /// Bodies rest from now on or no longer: `changed` are those of which that may have changed. What was put aside goes
  /// on as if it had never been.
  void rest(std::span<const int> changed, const std::function<bool(int body)>& rests);

  /// Of pairs of bodies of which one is not at rest.
  const std::vector<ContactHistory>& histories() const { return histories_; }
  const RestingContacts& resting() const { return resting_; }

  void archive(auto& state) {
    state(any_bonded_, resting_, histories_, keys_, broken_);
    if (state.reads()) sort_by_body();
  }

 private:
  using History = ContactHistory;
  /// What a body was held by, one for all contacts of a normal: all that is asked of it in every search, side by side.
  struct Hold {
    Vec3 normal;   // towards the body
    double depth;  // m, the deepest
    int by;        // the other body
  };
  std::span<const int> histories_of_either(int body_a, int body_b) const;
  std::span<const Hold> holds(int body) const;
  static Hold hold_of(const History& history, int body);
  const History* with_key(std::uint64_t key) const;
  const History* nearest_face_face(const FoundPoint& point, double distance) const;
  void list_successors();
  const FoundPoint* successor_of(const History& history) const;
  void add_forces(const History& history, const FoundPoint& point, TransferredHistory& sum) const;
  void sort_by_family();
  void sort_by_body();
  void list_holds();

  bool by_key_alone_;
  ContactTolerances tolerances_;
  double flush_cosine_;  // of the largest angle between normals that are along one direction
  bool any_bonded_ = false;
  RestingContacts resting_;
  std::vector<History> histories_;      // sorted by key
  std::vector<std::uint64_t> keys_;     // of histories_
  std::span<const FoundPoint> points_;  // of this step, and …
  std::vector<int> own_;                // … the history with the key of each; −1: none
  std::vector<int> by_family_;      // once they are asked for: numbers of histories_, sorted by family and then along x
  std::vector<int> of_body_;        // numbers of histories_: those of body b from …
  std::vector<int> of_body_begin_;  // … of_body_begin_[b] to of_body_begin_[b + 1]
  std::vector<Hold> holds_;         // those of body b from holds_begin_[b] to holds_begin_[b + 1]
  std::vector<int> holds_begin_;
  PointsByBodies by_bodies_;                              // those that histories may go on in
  std::vector<std::uint64_t> face_face_families_;         // families with an area, sorted
  std::vector<std::pair<std::uint64_t, int>> transfers_;  // key of a point, number of a history; sorted
  std::vector<std::uint64_t> broken_;                     // families, sorted
};

}  // namespace talus
