#include "solve/turning_contacts.hpp"

namespace talus {

namespace {

/// Of the tolerance: a way that is less leads no normal astray …
constexpr double unseen = 0.1;
/// … and so much deeper is right. It adds up: a contact that touches anew in each step never pushes out what it was
/// wrong by.
constexpr double negligible = 1e-3;

/// Shear goes on in the new plane with its length kept.
void turn(ContactPoint& point, const ContactDetector::Turned& turned) {
  const double length = point.shear_start.norm();
  point.normal = turned.normal;
  point.gap = turned.gap + point.overlap;
  point.shear_start -= turned.normal * turned.normal.dot(point.shear_start);
  if (const double left = point.shear_start.norm(); left > 0) point.shear_start *= length / left;
}

}  // namespace

bool follow_turning(ContactSet& contacts, const ContactLinks& links,
                    const std::function<ContactDetector::Turned(int point)>& turned, const Increment& d,
                    double tolerance) {
  bool any = false;
  for (int i = 0; i < links.moves().size(); ++i) {
    ContactPoint& point = contacts.points[i];
    const double limit = tolerance * point.size;
    const Vec3 way = links.moves().increment(i, d);
    if (point.bonded || way.norm() < unseen * limit) continue;
    const ContactDetector::Turned at_end = turned(i);
    const double depth = -at_end.gap - at_end.normal.dot(way), known = point.overlap - links.gap(i, d);
    if (!(depth > limit && depth > known + negligible * limit)) continue;
    turn(point, at_end);
    any = true;
  }
  return any;
}

}  // namespace talus
