#include "removability/removability.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace talus {

namespace {

constexpr double parallel = 1e-6;  // of a unit vector: directions that part by less are one

using Planes = std::span<const HoldingPlane>;

bool open(Planes planes, const Vec3& direction) {
  return std::all_of(planes.begin(), planes.end(),
                     [&](const HoldingPlane& plane) { return plane.normal.dot(direction) <= parallel; });
}

/// An open direction lies in the middle of the cone or on an edge of it, where two planes meet; planes that are all
/// parallel leave what lies in them.
bool has_open_direction(Planes planes) {
  if (planes.empty()) return true;
  bool all_parallel = true;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const Vec3 along = planes[i].normal.cross(planes[j].normal);
      if (along.norm() < parallel) continue;
      all_parallel = false;
      if (open(planes, along.normalized()) || open(planes, -along.normalized())) return true;
    }
  return all_parallel;
}

/// A part of the force along which the block may go, and what carries the rest.
struct Motion {
  Vec3 along = Vec3::Zero();  ///< of the force, that drives the block
  std::vector<int> on;
  double strength = 0;
};

std::optional<Motion> falling(Planes planes, const Vec3& force) {
  if (!open(planes, force)) return {};
  Motion motion{force, {}, 0};
  for (const HoldingPlane& plane : planes)
    if (plane.normal.dot(force) >= -parallel) motion.strength += plane.cohesion;  // upright: shears along it
  return motion;
}

std::optional<Motion> sliding_on(Planes planes, int i, const Vec3& force, double weight) {
  const double pressed = planes[i].normal.dot(force);
  const Vec3 along = force - pressed * planes[i].normal;
  if (pressed <= parallel || !open(planes, along)) return {};
  return Motion{along, {i}, pressed * weight * planes[i].friction + planes[i].cohesion};
}

std::optional<Motion> sliding_on(Planes planes, int i, int j, const Vec3& force, double weight) {
  const Vec3 &a = planes[i].normal, &b = planes[j].normal;
  const Vec3 line = a.cross(b);
  const double sine_squared = line.squaredNorm(), cosine = a.dot(b);
  if (sine_squared < parallel * parallel) return {};
  const Vec3 along = line * (force.dot(line) / sine_squared);
  const double on_a = (force.dot(a) - cosine * force.dot(b)) / sine_squared;
  const double on_b = (force.dot(b) - cosine * force.dot(a)) / sine_squared;
  if (on_a < -parallel || on_b < -parallel || !open(planes, along)) return {};
  return Motion{
      along,
      {i, j},
      weight * (on_a * planes[i].friction + on_b * planes[j].friction) + planes[i].cohesion + planes[j].cohesion};
}

/// `force` is a unit vector, `weight` its size.
std::optional<Motion> motion_by(Planes planes, const Vec3& force, double weight) {
  if (auto motion = falling(planes, force)) return motion;
  const int n = static_cast<int>(planes.size());
  for (int i = 0; i < n; ++i)
    if (auto motion = sliding_on(planes, i, force, weight)) return motion;
  std::optional<Motion> weakest;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      if (auto motion = sliding_on(planes, i, j, force, weight))
        if (!weakest || motion->strength < weakest->strength) weakest = motion;
  return weakest;
}

}  // namespace

Removability removability(Planes planes, bool has_free_face, const Vec3& force) {
  Removability result;
  if (!has_open_direction(planes)) {
    result.leaving = has_free_face ? Leaving::tapered : Leaving::enclosed;
    return result;
  }
  result.leaving = Leaving::stable;
  const double weight = force.norm();
  if (!(weight > 0)) return result;
  const auto motion = motion_by(planes, force / weight, weight);
  if (!motion || motion->along.norm() <= parallel) return result;
  constexpr Leaving by_planes[]{Leaving::falls, Leaving::slides_on_one, Leaving::slides_on_two};
  result.leaving = by_planes[motion->on.size()];
  result.direction = motion->along.normalized();
  result.on = motion->on;
  result.factor = motion->strength / (weight * motion->along.norm());
  return result;
}

}  // namespace talus
