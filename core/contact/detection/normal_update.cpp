#include "contact/detection/normal_update.hpp"

#include <functional>

#include "base/parallel.hpp"

namespace talus {
namespace {

constexpr int normals_worth_a_thread = 256;

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
  const auto foresee = [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      ContactPoint& point = contacts.points[i];
      const Vec3 u = sliding(point), along = u - point.normal * point.normal.dot(u);
      if (slides(point, along.norm(), tolerances.foreseen_slide * point.size)) turn(point, middle_normal(i));
    }
  };
  in_parallel(static_cast<int>(contacts.points.size()), normals_worth_a_thread, std::ref(foresee));
}

bool NormalUpdate::update(ContactSet& contacts, const ContactLinks& links,
                          const std::function<ContactDetector::UpdatedNormal(int point)>& updated_normal,
                          const Increment& d, double tolerance, const ContactTolerances& tolerances) {
  slides_.clear();
  for (int i = 0; i < links.moves().size(); ++i) {
    const ContactPoint& point = contacts.points[i];
    const Vec3 displacement = links.moves().increment(i, d);
    if (slides(point, displacement.norm(), tolerances.noticeable_slide * tolerance * point.size))
      slides_.push_back({i, displacement, {Vec3::Zero(), 0}});
  }
  const auto look = [&](int first, int last) {
    for (int i = first; i < last; ++i) slides_[i].at_end = updated_normal(slides_[i].point);
  };
  in_parallel(static_cast<int>(slides_.size()), normals_worth_a_thread, std::ref(look));
  bool any = false;
  for (const auto& [number, displacement, at_end] : slides_) {
    ContactPoint& point = contacts.points[number];
    const double limit = tolerance * point.size;
    const double depth = -at_end.gap;
    const double known = point.initial_interference - point.gap - point.normal.dot(displacement);
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
