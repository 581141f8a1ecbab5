#include "contact/narrow/inside.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace talus {

bool lies_inside(const StepGeometry& step, int body, const Vec3& point) {
  double angle = 0;
  for (int f = step.features.facet_begin[body]; f < step.features.facet_begin[body + 1]; ++f) {
    const auto& n = step.features.facets[f].nodes;
    const Vec3 a = step.x[n[0]] - point, b = step.x[n[1]] - point, c = step.x[n[2]] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle > 2 * std::numbers::pi;
}

}  // namespace talus
