#include "mesh/inner_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mesh/structured_mesh.hpp"

namespace talus {
namespace {

bool holds(const TetMesh& mesh, const Vec3& point) {
  const auto volume = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a);
  };
  return std::ranges::any_of(mesh.tetrahedra, [&](const auto& t) {
    const Vec3 &a = mesh.nodes[t[0]], &b = mesh.nodes[t[1]], &c = mesh.nodes[t[2]], &d = mesh.nodes[t[3]];
    return volume(point, b, c, d) > 0 && volume(a, point, c, d) > 0 && volume(a, b, point, d) > 0 &&
           volume(a, b, c, point) > 0;
  });
}

TEST(InnerPoint, OfATetrahedronIsTheCentreOfItsInscribedBall) {
  // Of a cube's corner: as far from the three legs as from the slanted face, 1 / (3 + √3).
  const TetMesh corner{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2, 3}}};
  EXPECT_TRUE(inner_point(corner).isApprox(Vec3::Constant(1 / (3 + std::sqrt(3))), 1e-14));
}

/// Two arms of an angle: the middle of all nodes lies between them, in the air.
TEST(InnerPoint, LiesInABlockWhoseMiddleIsOutside) {
  TetMesh angle = box_mesh(Vec3(0, 0, 0), Vec3(10, 1, 1), 10, 1, 1);
  const TetMesh arm = box_mesh(Vec3(0, 1, 0), Vec3(1, 10, 1), 1, 9, 1);
  const auto first = static_cast<int>(angle.nodes.size());
  angle.nodes.insert(angle.nodes.end(), arm.nodes.begin(), arm.nodes.end());
  for (auto t : arm.tetrahedra) {
    for (int& node : t) node += first;
    angle.tetrahedra.push_back(t);
  }
  Vec3 middle = Vec3::Zero();
  for (const Vec3& node : angle.nodes) middle += node / static_cast<double>(angle.nodes.size());
  EXPECT_FALSE(holds(angle, middle));
  EXPECT_TRUE(holds(angle, inner_point(angle)));
}

TEST(InnerPoint, NeedsTetrahedra) { EXPECT_THROW(inner_point({}), std::invalid_argument); }

}  // namespace
}  // namespace talus
