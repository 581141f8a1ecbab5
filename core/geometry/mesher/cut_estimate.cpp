#include "geometry/mesher/cut_estimate.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace talus {
namespace {

/// A joint that meets the box, and where it ends.
struct Sheet {
  Plane plane;
  std::vector<Plane> ends;  ///< their normals point outwards
};

bool meets(const Plane& plane, const Eigen::AlignedBox3d& box) {
  return std::abs(plane.distance(box.center())) < plane.normal.cwiseAbs().dot(box.sizes()) / 2;
}

Sheet sheet_of(const ActingJoint& joint) {
  Sheet sheet{joint.plane, {}};
  Vec3 centre = Vec3::Zero();
  for (const Vec3& corner : joint.outline) centre += corner / static_cast<double>(joint.outline.size());
  for (std::size_t k = 0; k < joint.outline.size(); ++k) {
    const Vec3 &a = joint.outline[k], &b = joint.outline[(k + 1) % joint.outline.size()];
    Vec3 outwards = (b - a).cross(joint.plane.normal).normalized();
    if (outwards.dot(centre - a) > 0) outwards = -outwards;
    sheet.ends.push_back({outwards, outwards.dot(a)});
  }
  return sheet;
}

bool holds(const Sheet& sheet, const Vec3& point) {
  return std::ranges::all_of(sheet.ends, [&](const Plane& end) { return end.distance(point) <= 0; });
}

/// The line of two planes, as long as it is still within what was asked for.
struct Line {
  Vec3 point, direction;
  double from = -HUGE_VAL, to = HUGE_VAL;

  void end_at(const Vec3& outwards, double offset) {
    const double speed = outwards.dot(direction), left = offset - outwards.dot(point);
    if (speed > 0) to = std::min(to, left / speed);
    if (speed < 0) from = std::max(from, left / speed);
    if (speed == 0 && left < 0) to = -HUGE_VAL;
  }
};

constexpr double parallel = 1e-9;

bool meet(const Sheet& a, const Sheet& b, const Eigen::AlignedBox3d& box) {
  const Vec3 direction = a.plane.normal.cross(b.plane.normal);
  if (direction.norm() < parallel) return false;
  Line line{(a.plane.offset * b.plane.normal.cross(direction) + b.plane.offset * direction.cross(a.plane.normal)) /
                direction.squaredNorm(),
            direction};
  for (int axis = 0; axis < 3; ++axis) {
    line.end_at(Vec3::Unit(axis), box.max()[axis]);
    line.end_at(-Vec3::Unit(axis), -box.min()[axis]);
  }
  for (const Sheet* sheet : {&a, &b})
    for (const Plane& end : sheet->ends) line.end_at(end.normal, end.offset);
  return line.from < line.to;
}

bool meet(const Sheet& a, const Sheet& b, const Sheet& c, const Eigen::AlignedBox3d& box) {
  const double determinant = a.plane.normal.dot(b.plane.normal.cross(c.plane.normal));
  if (std::abs(determinant) < parallel) return false;
  const Vec3 point =
      (a.plane.offset * b.plane.normal.cross(c.plane.normal) + b.plane.offset * c.plane.normal.cross(a.plane.normal) +
       c.plane.offset * a.plane.normal.cross(b.plane.normal)) /
      determinant;
  return box.contains(point) && holds(a, point) && holds(b, point) && holds(c, point);
}

/// How many pairs of `count` things, or triples, are true for `test`.
class Sampling {
 public:
  explicit Sampling(std::size_t count) : count_(count), pick_(0, count - 1) {}

  double pairs(const auto& test) {
    const auto n = static_cast<double>(count_), all = n * (n - 1) / 2;
    long found = 0;
    if (all <= most) {
      for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t j = i + 1; j < count_; ++j) found += test(i, j);
      return static_cast<double>(found);
    }
    return all * fraction([&] {
             const std::size_t i = pick(), j = pick();
             return i == j ? skipped : test(i, j);
           });
  }

  double triples(const auto& test) {
    const auto n = static_cast<double>(count_), all = n * (n - 1) * (n - 2) / 6;
    long found = 0;
    if (all <= most) {
      for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t j = i + 1; j < count_; ++j)
          for (std::size_t k = j + 1; k < count_; ++k) found += test(i, j, k);
      return static_cast<double>(found);
    }
    return all * fraction([&] {
             const std::size_t i = pick(), j = pick(), k = pick();
             return i == j || j == k || i == k ? skipped : test(i, j, k);
           });
  }

 private:
  static constexpr int most = 100000;  // looked at
  static constexpr int skipped = -1;

  double fraction(const auto& look) {
    long found = 0;
    for (int tried = 0; tried < most;) {
      const int seen = look();
      if (seen == skipped) continue;
      found += seen;
      ++tried;
    }
    return static_cast<double>(found) / most;
  }
  std::size_t pick() { return pick_(chance_); }

  std::size_t count_;
  std::mt19937 chance_;
  std::uniform_int_distribution<std::size_t> pick_;
};

/// Of a part, s and bytes: cut by OpenCASCADE out of a cube, 80 to 1 590 of them by random joints and 216 to 1 331 by
/// three sets; and as cells, 50 000 and 130 000. What is held grows with their corners (mesh_estimate.cpp).
constexpr double seconds_of_volume = 5e-3, seconds_of_cell = 3e-5, bytes_of_volume = 56e3, bytes_of_cell = 8e3;

/// s that a solid of triangles takes to become tetrahedra, which are then cut: 2 at ten thousand, 80 at a hundred
/// thousand. Columns under a terrain take none to speak of.
double seconds_to_cells(const TriangleSolid& solid) {
  constexpr double of_one = 8e-7, power = 1.6;
  return solid.terrain_like() ? 0 : of_one * std::pow(static_cast<double>(solid.triangles.size()), power);
}

}  // namespace

double parts_of_box(std::span<const ActingJoint> joints, const Eigen::AlignedBox3d& box) {
  std::vector<Sheet> sheets;
  for (const ActingJoint& joint : joints)
    if (meets(joint.plane, box)) sheets.push_back(sheet_of(joint));
  if (sheets.empty()) return 1;
  Sampling sampling(sheets.size());
  const double lines =
      sampling.pairs([&](std::size_t i, std::size_t j) -> int { return meet(sheets[i], sheets[j], box); });
  const double points = sampling.triples(
      [&](std::size_t i, std::size_t j, std::size_t k) -> int { return meet(sheets[i], sheets[j], sheets[k], box); });
  return 1 + static_cast<double>(sheets.size()) + lines + points;
}

MesherCutAhead cut_ahead(const MesherJob& job, const ImportedModel& model) {
  MesherCutAhead ahead;
  for (std::size_t s = 0; s < job.solids.size(); ++s) {
    const ImportedSolid& solid = model.solids[s];
    if (!solid.is_body()) continue;
    const double parts =
        parts_of_box(acting_joints(job, static_cast<int>(s), model.origin, solid.bounds), solid.bounds);
    ahead.blocks += parts;
    ahead.seconds +=
        seconds_to_cells(solid.triangles) + parts * (solid.is_cells() ? seconds_of_cell : seconds_of_volume);
    ahead.bytes += parts * (solid.is_cells() ? bytes_of_cell : bytes_of_volume);
  }
  return ahead;
}

}  // namespace talus
