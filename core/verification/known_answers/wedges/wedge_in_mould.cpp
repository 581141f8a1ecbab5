#include "verification/known_answers/wedges/wedge_in_mould.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace talus {

namespace {

/// The corner of plane, top and front.
Vec3 where_it_meets_the_top(const Vec3& normal, double length) {
  return {length, -length * normal.x() / normal.y(), 0};
}

}  // namespace

WedgePlanes WedgeShape::planes() const {
  const Vec3 line = (foot - apex).normalized();
  return {{(side_1 - apex).cross(line).normalized(), line.cross(side_2 - apex).normalized()}, line};
}

WedgeShape wedge_between(const Vec3& normal_1, const Vec3& normal_2, double length) {
  const Vec3 line = normal_1.cross(normal_2);
  const Vec3 foot = line * (length / line.x());
  return {Vec3::Zero(), foot, where_it_meets_the_top(normal_1, length), where_it_meets_the_top(normal_2, length)};
}

ClosedSurface mould(const WedgeShape& wedge) {
  const double width = 2 * std::max(-wedge.side_1.y(), wedge.side_2.y());
  const double back = -wedge.length(), front = wedge.length(), bottom = 2 * wedge.foot.z();
  ClosedSurface surface;
  surface.nodes = {wedge.apex,
                   wedge.foot,
                   wedge.side_1,
                   wedge.side_2,
                   {back, -width, 0},
                   {front, -width, 0},
                   {front, width, 0},
                   {back, width, 0},
                   {back, -width, bottom},
                   {front, -width, bottom},
                   {front, width, bottom},
                   {back, width, bottom}};
  surface.triangles = {{0, 2, 1}, {0, 1, 3},                                        // the notch
                       {4, 5, 2}, {4, 2, 0},  {4, 0, 7},  {0, 3, 7},   {3, 6, 7},   // top
                       {2, 5, 9}, {2, 9, 1},  {1, 9, 10}, {1, 10, 3},  {3, 10, 6},  // front
                       {4, 8, 9}, {4, 9, 5},  {7, 6, 10}, {7, 10, 11},              // sides
                       {8, 4, 7}, {8, 7, 11}, {8, 10, 9}, {8, 11, 10}};             // back and bottom
  return surface;
}

CaseScene wedge_in_mould(const WedgeShape& wedge, const Mat3& turn, const Material& rock, const Joint& planes,
                         int refinements) {
  CaseScene scene;
  scene.add_material(rock);
  scene.add_joint(planes);

  ClosedSurface ground = mould(wedge);
  for (Vec3& node : ground.nodes) node = turn * node;
  scene.add_ground("mould", ground.nodes, ground.triangles);

  TetMesh mesh;
  for (const Vec3& corner : {wedge.apex, wedge.foot, wedge.side_1, wedge.side_2}) mesh.nodes.push_back(turn * corner);
  mesh.tetrahedra = {{0, 2, 1, 3}};
  for (int i = 0; i < refinements; ++i) mesh = refined(mesh);
  scene.add_block("wedge", std::move(mesh), BodyKind::tetrahedra);
  return scene;
}

WedgePlanes turned(const WedgePlanes& planes, const Mat3& turn) {
  return {{turn * planes.normals[0], turn * planes.normals[1]}, turn * planes.line};
}

}  // namespace talus
