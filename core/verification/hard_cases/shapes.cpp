#include "verification/hard_cases/shapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "base/units.hpp"

namespace talus {

namespace {

/// In order about their mean, counter-clockwise seen against the normal.
std::vector<int> around(const std::vector<Vec3>& corners, std::vector<int> face, const Vec3& normal) {
  Vec3 middle = Vec3::Zero();
  for (const int c : face) middle += corners[c] / static_cast<double>(face.size());
  const Vec3 first = (corners[face.front()] - middle).normalized(), second = normal.cross(first);
  const auto angle = [&](int c) {
    return std::atan2((corners[c] - middle).dot(second), (corners[c] - middle).dot(first));
  };
  std::sort(face.begin(), face.end(), [&](int a, int b) { return angle(a) < angle(b); });
  return face;
}

/// The corners in the plane of three, if all others lie on its inner side.
std::vector<int> face_through(const std::vector<Vec3>& corners, const Vec3& point, const Vec3& normal) {
  constexpr double flat = 1e-9;  // m
  std::vector<int> face;
  for (int c = 0; c < static_cast<int>(corners.size()); ++c) {
    const double height = normal.dot(corners[c] - point);
    if (height > flat) return {};
    if (height > -flat) face.push_back(c);
  }
  return face;
}

void shift_points(std::vector<PointLoad>& loads, std::vector<Constraint>& constraints, const Vec3& shift) {
  for (PointLoad& load : loads) load.at += shift;
  for (Constraint& constraint : constraints)
    if (constraint.at) *constraint.at += shift;
}

}  // namespace

TetMesh convex_mesh(const std::vector<Vec3>& corners, const std::vector<std::vector<int>>& faces) {
  TetMesh mesh{corners, {}};
  Vec3 middle = Vec3::Zero();
  for (const Vec3& corner : corners) middle += corner / static_cast<double>(corners.size());
  const int centre = static_cast<int>(corners.size());
  mesh.nodes.push_back(middle);
  for (const std::vector<int>& face : faces)
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      mesh.tetrahedra.push_back({face[0], face[k + 1], face[k], centre});
  return mesh;
}

TetMesh hull_mesh(const std::vector<Vec3>& corners) {
  std::set<std::vector<int>> known;
  std::vector<std::vector<int>> faces;
  const int n = static_cast<int>(corners.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k)
        for (const double sign : {1.0, -1.0}) {
          const Vec3 normal = sign * (corners[j] - corners[i]).cross(corners[k] - corners[i]).normalized();
          const std::vector<int> face = face_through(corners, corners[i], normal);
          if (!face.empty() && known.insert(face).second) faces.push_back(around(corners, face, normal));
        }
  return convex_mesh(corners, faces);
}

TetMesh welded(const std::vector<TetMesh>& parts) {
  TetMesh whole;
  std::map<std::tuple<double, double, double>, int> places;
  for (const TetMesh& part : parts)
    for (std::array<int, 4> tetrahedron : part.tetrahedra) {
      for (int& node : tetrahedron) {
        const Vec3& x = part.nodes[node];
        const auto [place, is_new] = places.try_emplace({x.x(), x.y(), x.z()}, static_cast<int>(whole.nodes.size()));
        if (is_new) whole.nodes.push_back(x);
        node = place->second;
      }
      whole.tetrahedra.push_back(tetrahedron);
    }
  return whole;
}

TetMesh grid_mesh(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z,
                  const std::function<bool(int, int, int)>& solid) {
  std::vector<TetMesh> cells;
  for (std::size_t k = 0; k + 1 < z.size(); ++k)
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        if (solid(static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)))
          cells.push_back(box_mesh({x[i], y[j], z[k]}, {x[i + 1], y[j + 1], z[k + 1]}, 1, 1, 1));
  return welded(cells);
}

TetMesh spike(double width, double height) {
  const double w = width / 2;
  return hull_mesh({{-w, -w, 0}, {w, -w, 0}, {w, w, 0}, {-w, w, 0}, {0, 0, height}});
}

TetMesh wedge(double width, double length, double height) {
  const double w = width / 2, l = length / 2;
  return hull_mesh({{-w, -l, 0}, {w, -l, 0}, {w, l, 0}, {-w, l, 0}, {0, -l, height}, {0, l, height}});
}

TetMesh cube(double side) { return box_mesh(Vec3::Constant(-side / 2), Vec3::Constant(side / 2), 1, 1, 1); }

TetMesh prism(int sides, double radius, double height) {
  std::vector<Vec3> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double z : {0.0, height}) corners.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
  return hull_mesh(corners);
}

TetMesh ring(double inner, double thickness, int sides) {
  const double outer = inner + thickness;
  const auto at = [&](int k, double radius, double y) {
    const double angle = 2 * std::numbers::pi * ((k % sides) + 0.5) / sides;
    return Vec3(radius * std::cos(angle), y, radius * std::sin(angle));
  };
  std::vector<TetMesh> pieces;
  for (int k = 0; k < sides; ++k) {
    const double y = thickness / 2;
    pieces.push_back(
        hexahedron_mesh({at(k, inner, -y), at(k, outer, -y), at(k, inner, y), at(k, outer, y), at(k + 1, inner, -y),
                         at(k + 1, outer, -y), at(k + 1, inner, y), at(k + 1, outer, y)},
                        1, 1, 1));
  }
  return welded(pieces);
}

TetMesh hook(double width, double stem, double lip) {
  return grid_mesh({-1, 0, width, width + 1}, {-0.5, 0.5}, {-1, 0, lip, stem},
                   [](int i, int, int k) { return k == 0 || i == 2 || (i == 0 && k == 1); });
}

TetMesh slotted_box(double slot_width, double depth, double half_width, double half_length, double floor) {
  return grid_mesh({-half_width, -slot_width / 2, slot_width / 2, half_width}, {-half_length, half_length},
                   {-depth - floor, -depth, 0}, [](int i, int, int k) { return i != 1 || k == 0; });
}

TetMesh holed_box(double hole_width, double depth, double half_width, double floor) {
  const std::vector<double> lines{-half_width, -hole_width / 2, hole_width / 2, half_width};
  return grid_mesh(lines, lines, {-depth - floor, -depth, 0},
                   [](int i, int j, int k) { return i != 1 || j != 1 || k == 0; });
}

TetMesh placed(TetMesh mesh, const Mat3& turn, const Vec3& shift) {
  for (Vec3& node : mesh.nodes) node = turn * node + shift;
  return mesh;
}

TetMesh placed(TetMesh mesh, const Vec3& shift) { return placed(std::move(mesh), Mat3::Identity(), shift); }

Mat3 turn_about(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(radians(angle), axis.normalized()).toRotationMatrix();
}

Mat3 upside_down() { return turn_about(Vec3::UnitX(), 180); }

void shift_block(CaseScene& scene, const std::string& name, const Vec3& shift) {
  for (Block& block : scene.system.blocks)
    if (block.name == name)
      for (Vec3& node : block.mesh.nodes) node += shift;
}

void shift_scene(CaseScene& scene, const Vec3& shift) {
  for (const Block& block : scene.system.blocks) shift_block(scene, block.name, shift);
  shift_points(scene.project.loads, scene.project.constraints, shift);
  std::vector<PointLoad> no_loads;
  std::vector<Constraint> no_constraints;
  for (Stage& stage : scene.project.stages)
    shift_points(stage.loads ? *stage.loads : no_loads, stage.constraints ? *stage.constraints : no_constraints, shift);
}

}  // namespace talus
