#include "model/polyhedron.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

PolyhedronShape tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

PolyhedronShape cube(double size, const Vec3& corner) {
  PolyhedronShape shape;
  for (int i = 0; i < 8; ++i) shape.vertices.push_back(corner + size * Vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
  shape.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return shape;
}

void expect_refused(const PolyhedronShape& shape, const std::string& place, const std::string& problem,
                    const std::string& remedy) {
  try {
    validate_polyhedron(shape, Place() / "p");
    ADD_FAILURE() << "accepted; expected: " << problem;
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), place);
    EXPECT_THAT(error.problem(), HasSubstr(problem));
    EXPECT_THAT(error.remedy(), HasSubstr(remedy));
  }
}

TEST(Polyhedron, ClosedOnesPassAndHaveTheirVolume) {
  EXPECT_NO_THROW(validate_polyhedron(tetrahedron(), Place()));
  EXPECT_DOUBLE_EQ(signed_volume(tetrahedron()), 1.0 / 6);
  EXPECT_NO_THROW(validate_polyhedron(cube(2, {0, 0, 0}), Place()));
  EXPECT_DOUBLE_EQ(signed_volume(cube(2, {0, 0, 0})), 8);
}

TEST(Polyhedron, VolumeLosesNothingFarFromTheOrigin) {
  EXPECT_NO_THROW(validate_polyhedron(cube(0.5, {4e5, 5e6, 1000}), Place()));
  EXPECT_NEAR(signed_volume(cube(0.5, {4e5, 5e6, 1000})), 0.125, 1e-15);
}

TEST(Polyhedron, AConcaveFaceIsFine) {
  PolyhedronShape prism;  // an L of area 3, 1 thick
  const std::vector<std::array<double, 2>> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : outline) prism.vertices.push_back({x, y, z});
  }
  prism.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for (int i = 0; i < 6; ++i) prism.faces.push_back({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  EXPECT_NO_THROW(validate_polyhedron(prism, Place()));
  EXPECT_DOUBLE_EQ(signed_volume(prism), 3);
}

TEST(Polyhedron, AnOpenOneIsRefused) {
  auto shape = cube(1, {0, 0, 0});
  shape.faces.erase(shape.faces.begin() + 1);
  expect_refused(shape, "/p/faces/3", "open: no other face joins edge 4–6", "add the missing face");
}

TEST(Polyhedron, AnInsideOutOneIsRefused) {
  auto shape = tetrahedron();
  for (auto& face : shape.faces) std::reverse(face.begin(), face.end());
  expect_refused(shape, "/p", "inside out: its volume comes to -0.1666", "reverse the order");
}

TEST(Polyhedron, OneTurnedFaceIsRefused) {
  auto shape = tetrahedron();
  std::reverse(shape.faces[2].begin(), shape.faces[2].end());
  expect_refused(shape, "/p/faces/2", "in the same direction as face", "counter-clockwise seen from outside");
}

TEST(Polyhedron, BadNumbersAreRefused) {
  auto shape = tetrahedron();
  shape.faces[3][1] = 4;
  expect_refused(shape, "/p/faces/3/1", "there is no vertex 4", "use 0 to 3");
  shape.faces[3][1] = -1;
  expect_refused(shape, "/p/faces/3/1", "there is no vertex -1", "counted from 0");
  shape.faces[3][1] = 0;
  expect_refused(shape, "/p/faces/3", "uses vertex 0 twice", "once");
  shape.faces[3] = {0, 1};
  expect_refused(shape, "/p/faces/3", "at least 3 vertices", "remove the face");
}

TEST(Polyhedron, DegenerateOnesAreRefused) {
  auto shape = tetrahedron();
  shape.vertices[3] = {2, 0, 0};
  expect_refused(shape, "/p/faces/1", "no area", "move a vertex");
  shape.vertices[3] = shape.vertices[1];
  expect_refused(shape, "/p/vertices/3", "same point as vertex 1", "remove this one");
  shape.vertices[3][2] = std::numeric_limits<double>::quiet_NaN();
  expect_refused(shape, "/p/vertices/3/2", "not a finite number", "finite");
  EXPECT_THROW(validate_polyhedron({}, Place()), InputError);
}

TEST(Polyhedron, AFaceMayBeOffItsPlaneByRoundingOnly) {
  auto shape = cube(1000, {0, 0, 0});
  shape.vertices[7][2] += 0.001;  // coordinates to the millimetre
  EXPECT_NO_THROW(validate_polyhedron(shape, Place()));
  shape.vertices[7][2] += 1;
  expect_refused(shape, "/p/faces/1", "not plane: a vertex lies 0.25", "triangles");
}

}  // namespace
}  // namespace talus
