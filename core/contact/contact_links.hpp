#pragma once

#include "bodies/attachments.hpp"
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
  /// How the first body moves against the second.
  const Attachments& moves() const { return moves_; }
  /// Gap of a point at D [m].
  double gap(int i, const Increment& d) const { return point(i).gap + point(i).normal.dot(moves_.increment(i, d)); }

 private:
  const ContactSet& contacts_;
  Attachments moves_;
};

}  // namespace talus
