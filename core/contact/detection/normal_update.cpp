#include "contact/detection/normal_update.hpp"

namespace talus {
namespace {

/// Shear goes on in the new plane with its length kept.
void turn(ContactPoint& point, const Vec3& normal) {
  const double length = point.shear_start.norm();
  point.normal = normal;
  point.shear_start -= normal * normal.dot(point.shear_start);
  if (const double left = point.shear_start.norm(); left > 0) point.shear_start *= length / left;
}

/// What goes by more than a facet leaves its features.
bool slides(const ContactPoint& point, double by, double least) {
  return !point.bonded && by >= least && by <= point.size;
}

}  // namespace

void foresee_normals(ContactSet& contacts, const std::function<Vec3(const ContactPoint&)>& sliding,
                     const std::function<Vec3(int point)>& middle_normal, const ContactTolerances& tolerances) {
  for (std::size_t i = 0; i < contacts.points.size(); ++i) {
    ContactPoint& point = contacts.points[i];
    const Vec3 u = sliding(point), along = u - point.normal * point.normal.dot(u);
    if (slides(point, along.norm(), tolerances.foreseen_slide * point.size))
      turn(point, middle_normal(static_cast<int>(i)));
  }
}

bool update_normals(ContactSet& contacts, const ContactLinks& links,
                    const std::function<ContactDetector::UpdatedNormal(int point)>& updated_normal, const Increment& d,
                    double tolerance, const ContactTolerances& tolerances) {
  bool any = false;
  for (int i = 0; i < links.moves().size(); ++i) {
    ContactPoint& point = contacts.points[i];
    const double limit = tolerance * point.size;
    const Vec3 displacement = links.moves().increment(i, d);
    if (!slides(point, displacement.norm(), tolerances.noticeable_slide * limit)) continue;
    const ContactDetector::UpdatedNormal at_end = updated_normal(i);
    const double depth = -at_end.gap, known = point.initial_interference - links.gap(i, d);
    if (!(depth > limit && depth > known + tolerances.noticeable_deepening * limit)) continue;
    const double gap = at_end.gap - at_end.normal.dot(displacement) + point.initial_interference;
    // What is new begins without force: a normal along which it was in before would push from the start.
    if (point.is_new && gap < -limit) continue;
    turn(point, at_end.normal);
    point.gap = gap;
    any = true;
  }
  return any;
}

}  // namespace talus
