#pragma once

#include <algorithm>

#include "bodies/attachments.hpp"
#include "bodies/picked_bodies.hpp"
#include "contact/contact_point.hpp"

namespace talus {

/// The contact points of a step and how the bodies' unknowns move them: what every contact effect looks at.
class ContactLinks {
 public:
  /// Both outlive the links.
  ContactLinks(const BodySet& set, const ContactSet& contacts) : contacts_(contacts), moves_(set) {}

  /// Contacts were sought anew; the bodies stand at the start of the step. With mean arms they act on each other at one
  /// place.
  void connect(Arms arms = Arms::end);

  const ContactSet& contacts() const { return contacts_; }
  const ContactPoint& point(int i) const { return contacts_.points[i]; }
  bool of_the_same_bodies(int i, int j) const {
    return std::minmax({point(i).bodies[0], point(i).bodies[1]}) ==
           std::minmax({point(j).bodies[0], point(j).bodies[1]});
  }
  /// How the first body moves against the second.
  const Attachments& moves() const { return moves_; }
  /// Of these points those of picked bodies, which are written to `picked`; all where none are picked.
  const std::vector<int>* points_of(const PickedBodies* bodies, const std::vector<int>& all,
                                    std::vector<int>& picked) const;
  /// Gap of a point at D [m].
  double gap(int i, const Increment& d) const { return point(i).gap + point(i).normal.dot(moves_.increment(i, d)); }

 private:
  const ContactSet& contacts_;
  Attachments moves_;
};

}  // namespace talus
