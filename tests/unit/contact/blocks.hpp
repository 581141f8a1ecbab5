#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "base/rotation.hpp"
#include "contact/detection/contact_detector.hpp"
#include "mesh/surface.hpp"

namespace talus::testing {

/// Up to which gaps contacts are looked for [m].
inline constexpr double reach = 0.01;

/// A closed surface with its nodes.
struct Shape {
  std::vector<Vec3> nodes;
  std::vector<SurfaceTriangle> triangles;
};

inline int node_at(Shape& shape, std::map<std::array<long, 3>, int>& seen, const Vec3& p) {
  const auto round = [](double v) { return std::lround(v * 1e6); };
  const auto [it, added] =
      seen.emplace(std::array{round(p.x()), round(p.y()), round(p.z())}, static_cast<int>(shape.nodes.size()));
  if (added) shape.nodes.push_back(p);
  return it->second;
}

/// The faces that the cells of a grid [0, n]³ share with no other cell; `solid` says which cells there are. A cell has
/// the size 1 × 1 × 1; a face is cut into two triangles, along the other diagonal where `turned`.
inline Shape cells(std::array<int, 3> n, const std::function<bool(int, int, int)>& solid, bool turned = false) {
  Shape shape;
  std::map<std::array<long, 3>, int> seen;
  const auto filled = [&](std::array<int, 3> c) {
    for (int k = 0; k < 3; ++k) {
      if (c[k] < 0 || c[k] >= n[k]) return false;
    }
    return solid(c[0], c[1], c[2]);
  };
  for (int i = 0; i < n[0]; ++i) {
    for (int j = 0; j < n[1]; ++j) {
      for (int k = 0; k < n[2]; ++k) {
        if (!filled({i, j, k})) continue;
        for (int axis = 0; axis < 3; ++axis) {
          for (int side = 0; side < 2; ++side) {
            std::array<int, 3> next = {i, j, k};
            next[axis] += side ? 1 : -1;
            if (filled(next)) continue;
            const Vec3 cell(i, j, k);
            Vec3 origin = cell, u = Vec3::Unit((axis + 1) % 3), v = Vec3::Unit((axis + 2) % 3);
            if (side) {
              origin += Vec3::Unit(axis);
            } else {
              std::swap(u, v);
            }
            std::array<int, 4> q = {node_at(shape, seen, origin), node_at(shape, seen, origin + u),
                                    node_at(shape, seen, origin + u + v), node_at(shape, seen, origin + v)};
            if (turned) {
              shape.triangles.push_back({{q[0], q[1], q[3]}, -1});
              shape.triangles.push_back({{q[1], q[2], q[3]}, -1});
            } else {
              shape.triangles.push_back({{q[0], q[1], q[2]}, -1});
              shape.triangles.push_back({{q[0], q[2], q[3]}, -1});
            }
          }
        }
      }
    }
  }
  return shape;
}

inline Shape mapped(Shape shape, const std::function<Vec3(const Vec3&)>& map) {
  for (Vec3& p : shape.nodes) p = map(p);
  return shape;
}

/// A box between two corners, its faces cut into n cells along each axis.
inline Shape box(const Vec3& lower, const Vec3& upper, std::array<int, 3> n = {1, 1, 1}, bool turned = false) {
  const Vec3 step = (upper - lower).cwiseQuotient(Vec3(n[0], n[1], n[2]));
  return mapped(cells(
                    n, [](int, int, int) { return true; }, turned),
                [&](const Vec3& p) { return Vec3(lower + step.cwiseProduct(p)); });
}

/// A cube of 1 m that stands on one corner, at `tip`.
inline Shape on_a_corner(const Vec3& tip, int n = 2) {
  const Mat3 turn = rotation_onto(Vec3(1, 1, 1), Vec3(0, 0, 1));
  return mapped(box({0, 0, 0}, {1, 1, 1}, {n, n, n}), [&](const Vec3& p) { return Vec3(turn * p + tip); });
}

/// Bodies whose contacts are looked for. The first body is fixed unless told otherwise.
class Scene {
 public:
  int add(const Shape& shape, bool fixed = false) {
    surfaces_.push_back(std::make_unique<Surface>(make_surface(shape.nodes, shape.triangles)));
    bodies_.push_back({surfaces_.back().get(), static_cast<int>(x.size()), fixed, young, single_body, deforms});
    x.insert(x.end(), shape.nodes.begin(), shape.nodes.end());
    return static_cast<int>(bodies_.size()) - 1;
  }
  const std::vector<ContactBody>& bodies() const { return bodies_; }
  int first_node(int body) const { return bodies_[body].first_node; }
  int node_count(int body) const { return static_cast<int>(bodies_[body].surface->ring.size()); }
  double size(int body) const { return bodies_[body].surface->size; }

  void move(int body, const Vec3& by) {
    for (int i = 0; i < node_count(body); ++i) x[first_node(body) + i] += by;
  }

  ContactDetector& detector() {
    if (!detector_) {
      detector_ = std::make_unique<ContactDetector>(bodies_, laws, PairJoints(), settings);
    }
    return *detector_;
  }
  const ContactSet& detect(double within) {
    detector().detect(x, within, contacts);
    return contacts;
  }

  std::vector<Vec3> x;
  std::vector<JointLaw> laws = {JointLaw{.friction = 0.5}};
  ContactSettings settings;
  ContactSet contacts;
  double young = 1e9;                         ///< of the bodies that are added next
  bool single_body = false, deforms = false;  ///< are they rigid?

 private:
  std::vector<std::unique_ptr<Surface>> surfaces_;
  std::vector<ContactBody> bodies_;
  std::unique_ptr<ContactDetector> detector_;
};

/// The step is accepted: what touches sticks and bears what its stiffness says.
inline void accept_as_stuck(Scene& scene) {
  std::vector<ContactOutcome> outcomes(scene.contacts.points.size());
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const ContactPoint& p = scene.contacts.points[i];
    outcomes[i].gap = p.gap;
    outcomes[i].normal_force = std::max(0.0, -p.gap * p.normal_stiffness);
    outcomes[i].shear_force = 0.1 * outcomes[i].normal_force * p.normal.unitOrthogonal();
  }
  scene.detector().accept(scene.contacts, outcomes);
}

inline double total_area(const ContactSet& contacts) {
  double area = 0;
  for (const ContactPoint& p : contacts.points) area += p.area;
  return area;
}

}  // namespace talus::testing
