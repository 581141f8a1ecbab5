#include "contact/narrow/step_geometry.hpp"

#include <algorithm>

#include "contact/history/contact_memory.hpp"

namespace talus {

double StepGeometry::edge_tolerance(int body_a, int body_b) const {
  const double size = broad.size(body_a, body_b);
  return std::clamp(tolerances.edge_tolerance_per_penetration * deepest(body_a, body_b),
                    tolerances.least_edge_tolerance * size, tolerances.most_edge_tolerance * size);
}

double StepGeometry::largest_edge_tolerance(int body_a, int body_b) const {
  return tolerances.most_edge_tolerance * broad.size(body_a, body_b);
}

bool StepGeometry::sank_over_edge(double distance, double times, int body, int other, const Vec3& across) const {
  if (distance < tolerances.least_edge_tolerance * broad.size(body, other)) return true;
  if (!(distance < largest_edge_tolerance(body, other))) return false;
  const auto held_by_a_third = [&](int b, const Vec3& direction, int but) {
    return moved[b] ? memory.depth_along(b, direction, but) : 0;
  };
  return distance < times * std::max(held_by_a_third(other, across, body), held_by_a_third(body, -across, other));
}

bool StepGeometry::within_edge_tolerance(double distance, int body, int other, const Vec3& across) const {
  return sank_over_edge(distance, tolerances.edge_tolerance_per_penetration, body, other, across);
}

double StepGeometry::sunk_past_edge(int other, int body, const Vec3& across) const {
  if (!moved[other]) return 0;
  const double pushed_back = memory.depth_along(other, -across, body);
  if (!(pushed_back > 0)) return 0;
  const double deeper = pushed_back - memory.depth_along(other, across);
  return tolerances.edge_tolerance_per_penetration * std::max(0.0, deeper);
}

double StepGeometry::noticeable_depth(int body_a, int body_b) const {
  return tolerances.least_edge_tolerance / 2 * broad.size(body_a, body_b);
}

double StepGeometry::depth(int body_a, int body_b) const {
  const double most =
      std::min(tolerances.largest_depth * broad.size(body_a, body_b), std::min(widths[body_a], widths[body_b]) / 2);
  if (!have_moved(body_a, body_b)) return most;
  const double left =
      std::max(tolerances.depth_per_penetration * deepest(body_a, body_b), memory.depth_between(body_a, body_b));
  return std::min(reach(body_a, body_b) + left, most);
}

int StepGeometry::common_joint(int facet_a, int facet_b) const {
  const int joint = features.facets[facet_a].joint;
  return joint == features.facets[facet_b].joint ? joint : -1;
}

}  // namespace talus
