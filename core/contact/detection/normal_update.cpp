#include "contact/detection/normal_update.hpp"

namespace talus {
namespace {

/// Shear goes on in the new plane with its length kept.
void turn(ContactPoint& point, const ContactDetector::UpdatedNormal& updated) {
  const double length = point.shear_start.norm();
  point.normal = updated.normal;
  point.gap = updated.gap + point.initial_interference;
  point.shear_start -= updated.normal * updated.normal.dot(point.shear_start);
  if (const double left = point.shear_start.norm(); left > 0) point.shear_start *= length / left;
}

}  // namespace

bool update_normals(ContactSet& contacts, const ContactLinks& links,
                    const std::function<ContactDetector::UpdatedNormal(int point)>& updated_normal, const Increment& d,
                    double tolerance, const ContactTolerances& tolerances) {
  bool any = false;
  for (int i = 0; i < links.moves().size(); ++i) {
    ContactPoint& point = contacts.points[i];
    const double limit = tolerance * point.size;
    const Vec3 displacement = links.moves().increment(i, d);
    const double slides = displacement.norm();
    // What goes by more than a facet has left its features.
    if (point.bonded || slides < tolerances.noticeable_slide * limit || slides > point.size) continue;
    const ContactDetector::UpdatedNormal at_end = updated_normal(i);
    const double depth = -at_end.gap - at_end.normal.dot(displacement),
                 known = point.initial_interference - links.gap(i, d);
    if (!(depth > limit && depth > known + tolerances.noticeable_deepening * limit)) continue;
    turn(point, at_end);
    any = true;
  }
  return any;
}

}  // namespace talus
