#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rotation.hpp"
#include "base/units.hpp"
#include "unit/contact/blocks.hpp"

/// A sharp edge that has come past another by a little in both directions: which adjacent face holds it.
namespace talus {
namespace {

using testing::box;
using testing::cells;
using testing::mapped;
using testing::reach;
using testing::Scene;
using testing::Shape;

/// A cube whose upper right edge, along y, is touched by the lower left one of another.
Scene edge_on_edge(double past_the_side, double below_the_top) {
  Scene scene;
  scene.add(box({-1, -1, -1}, {0, 1, 0}), true);
  scene.add(mapped(box({0, -0.5, 0}, {1, 0.5, 1}),
                   [=](const Vec3& p) { return Vec3(p - Vec3(past_the_side, 0, below_the_top)); }));
  return scene;
}

void expect_all_normals(const ContactSet& contacts, const Vec3& normal) {
  EXPECT_FALSE(contacts.points.empty());
  for (const ContactPoint& p : contacts.points) EXPECT_LT((p.normal - normal).norm(), 1e-9) << p.normal.transpose();
}

TEST(SharpEdges, TheAdjacentFaceHasItThatTheEdgeIsLessDeepIn) {
  Scene beside = edge_on_edge(4e-4, 1e-3);
  expect_all_normals(beside.detect(reach), -Vec3::UnitX());
  Scene above = edge_on_edge(1e-3, 4e-4);
  expect_all_normals(above.detect(reach), -Vec3::UnitZ());
}

/// All points push as hard as they are deep.
void accept_as_found(Scene& scene, ContactSet contacts) {
  std::vector<ContactOutcome> outcomes;
  for (ContactPoint& p : contacts.points) {
    if (p.gap < 0) p.mode = ContactMode::stick;
    outcomes.push_back({.normal_force = std::max(0.0, -p.gap * p.normal_stiffness), .gap = p.gap});
  }
  scene.detector().accept(contacts, outcomes);
}

TEST(SharpEdges, WhatTheTwoPressIntoEachOtherDoesNotLetThemPass) {
  Scene scene = edge_on_edge(6e-4, 4e-4);
  accept_as_found(scene, scene.detect(reach));
  expect_all_normals(scene.detect(reach), -Vec3::UnitZ());
}

TEST(SharpEdges, WhatAThirdBodyCarriesPasses) {
  Scene scene = edge_on_edge(2e-4, 4e-4);
  scene.add(box({0, -1, -1}, {2, 1, 0}), true);  // flush with the first
  accept_as_found(scene, scene.detect(reach));
  EXPECT_FALSE(scene.detect(reach).points.empty());
  for (const ContactPoint& p : scene.contacts.points) EXPECT_NEAR(p.normal.x(), 0, 1e-9) << p.normal.transpose();
}

TEST(SharpEdges, WhatLiesDeeperInWhatCarriesItThanInWhatPressesItDownPasses) {
  // A corner ahead of its block, 1e-4 m above the top of the one that it slides over.
  const Mat3 turn = Eigen::AngleAxisd(radians(-45), Vec3::UnitZ()).toRotationMatrix();
  Scene scene;
  scene.add(box({-1, -1, -1}, {0, 1, 0}), true);
  scene.add(mapped(box({0, 0, 0}, {1, 1, 1}),
                   [&](const Vec3& p) { return Vec3(turn * p + Vec3(0.5 * p.z() - 2e-4, 0, 1e-4)); }));
  scene.add(box({0.3, -1, -1}, {2, 1, 5e-4}), true);
  scene.add(box({0, -1, 1 - 1e-4}, {2, 1, 2}), true);
  accept_as_found(scene, scene.detect(reach));
  EXPECT_FALSE(scene.detect(reach).points.empty());
  for (const ContactPoint& p : scene.contacts.points) EXPECT_NEAR(p.normal.x(), 0, 1e-9) << p.normal.transpose();
}

TEST(SharpEdges, ACornerThatHasSunkIntoAFloorIsHeldByTheFootOfAWallThatStandsThere) {
  // An edge that leans as the wall does comes to lie on it; its lower end is 5e-4 m deep in the floor.
  const Mat3 turn = Eigen::AngleAxisd(radians(45), Vec3::UnitZ()).toRotationMatrix();
  for (const double leaning : {0.0, 0.5}) {
    const auto lean = [=](const Vec3& p) { return Vec3(p + leaning * p.z() * Vec3::UnitX()); };
    Scene scene;
    scene.add(box({-3, -2, -1}, {2, 2, 0}), true);
    const int wall = scene.add(mapped(box({0, -2, 0}, {1, 2, 2}), lean), true);
    const int block = scene.add(
        mapped(box({-1, 0, 0}, {0, 1, 1}), [&](const Vec3& p) { return Vec3(lean(turn * p) - Vec3(5e-3, 0, 5e-4)); }));
    accept_as_found(scene, scene.detect(reach));
    scene.move(block, 5.4e-3 * Vec3::UnitX());
    const Vec3 normal = Vec3(1, 0, -leaning).normalized();
    int held = 0;
    for (const ContactPoint& p : scene.detect(reach).points)
      held += p.bodies[0] == wall && p.bodies[1] == block && (p.normal - normal).norm() < 1e-9 &&
              p.gap - p.initial_interference < -3e-4;
    EXPECT_EQ(held, 2) << leaning;  // both ends of the edge
  }
}

TEST(SharpEdges, AnEdgeDoesNotTouchTheFaceThatItsEndHasNotComeThrough) {
  // An upright block stands on one corner, 5e-4 m below the top and 9e-3 m from the side: its upright edge passes the
  // block's edge by as much.
  const Mat3 turn = Eigen::AngleAxisd(radians(-45), Vec3::UnitZ()).toRotationMatrix();
  Scene scene;
  scene.add(box({-1, -1, -1}, {0, 1, 0}), true);
  scene.add(mapped(box({0, 0, 0}, {1, 1, 1}), [&](const Vec3& p) {
    const Vec3 turned = turn * p;
    return Vec3(turned + Vec3(-9e-3, 0, 0.14 * turned.x() - 5e-4));
  }));
  expect_all_normals(scene.detect(reach), -Vec3::UnitZ());
}

TEST(SharpEdges, WhatPressesOnTheFarEndOfAFaceDoesNotHoldTheEdge) {
  // Two cubes' edges cross at 0.02 rad; a third body lies at the foot of the lower one's side, within 6° of which is
  // the upper one's.
  const Vec3 apart = Vec3(1, 0, 1).normalized();
  const Mat3 turn = (Eigen::AngleAxisd(0.02, apart) * Eigen::AngleAxisd(radians(6), Vec3::UnitY())).toRotationMatrix();
  Scene scene;
  scene.add(box({-1, -1, -1}, {0, 1, 0}), true);
  scene.add(mapped(box({0, -0.5, 0}, {1, 0.5, 1}), [&](const Vec3& p) { return Vec3(turn * p - 1e-5 * apart); }));
  scene.add(box({0, -1, -1}, {0.5, 1, -0.9}));
  const ContactSet& contacts = scene.detect(reach);
  const auto holds_the_edge = [&](const ContactPoint& p) {
    return p.bodies[0] == 0 && p.bodies[1] == 1 && (p.normal + apart).norm() < 1e-9 && std::abs(p.gap + 1e-5) < 1e-9;
  };
  EXPECT_TRUE(std::any_of(contacts.points.begin(), contacts.points.end(), holds_the_edge));
}

TEST(SharpEdges, AnEdgeTouchesAConvexEdgeHoweverFlat) {
  // A roof whose slopes lean 1.25° either way, and the edge of a bar across its top edge: the ends hang free.
  const auto roof = [](const Vec3& p) { return Vec3(p - Vec3(0, 0, std::tan(radians(1.25)) * std::abs(p.x()))); };
  const Mat3 turn = Eigen::AngleAxisd(radians(45), Vec3::UnitX()).toRotationMatrix();
  Scene scene;
  scene.add(mapped(box({-1, -1, -1}, {1, 1, 0}, {2, 1, 1}), roof), true);
  scene.add(
      mapped(box({-0.8, 0, 0}, {0.9, 0.1, 0.1}), [&](const Vec3& p) { return Vec3(turn * p - 5e-4 * Vec3::UnitZ()); }));
  const ContactSet& contacts = scene.detect(reach);
  ASSERT_EQ(contacts.points.size(), 1u);
  EXPECT_NEAR(contacts.points[0].gap + contacts.points[0].initial_interference, -5e-4, 1e-9);
  EXPECT_LT(contacts.points[0].position.norm(), 1e-9);
  expect_all_normals(contacts, -Vec3::UnitZ());
}

/// The second body comes into its place in one step, from where it touched nothing.
const ContactSet& come(Scene& scene, const Vec3& from) {
  scene.move(1, from);
  accept_as_found(scene, scene.detect(reach));
  scene.move(1, -from);
  return scene.detect(reach);
}

TEST(SharpEdges, ACornerThatSinksInAtAnEdgeIsLeftToOneAdjacentFace) {
  // A roof whose slopes lean 20° either way, and a steep corner that comes 1e-3 m down through it, beside its top edge.
  const auto roof = [](const Vec3& p) { return Vec3(p - Vec3(0, 0, std::tan(radians(20)) * std::abs(p.x()))); };
  const Mat3 on_a_corner = rotation_onto(Vec3::Ones(), Vec3::UnitZ());
  for (const double beside : {-1e-4, -1e-5, 1e-5, 1e-4}) {
    Scene scene;
    scene.add(mapped(box({-1, -1, -1}, {1, 1, 0}, {2, 1, 1}), roof), true);
    scene.add(mapped(box({0, 0, 0}, {0.2, 0.2, 0.2}), [&](const Vec3& p) {
      const Vec3 turned = on_a_corner * p;
      return Vec3(turned.x() + beside, turned.y() + 0.3, 5 * turned.z() - 1e-3);
    }));
    double deepest = 0;
    for (const ContactPoint& p : come(scene, 2e-3 * Vec3::UnitZ()).points)
      deepest = std::max(deepest, p.initial_interference - p.gap);
    EXPECT_NEAR(deepest, 1e-3 * std::cos(radians(20)), 1e-4) << beside;
  }
}

TEST(SharpEdges, AnEdgeThatPassesBesideAnAcuteEdgeIsNotDeepInIt) {
  // A brow that overhangs by 30°, and a bar below it that ends in a slope of 20°, 1e-3 m from the brow's edge: seen
  // from above, the bar's lower edge crosses that edge.
  const auto leaning = [](double degrees) {
    return [=](const Vec3& p) { return Vec3(p + Vec3(std::tan(radians(degrees)) * p.z(), 0, 0)); };
  };
  const Mat3 turn = Eigen::AngleAxisd(radians(45), Vec3::UnitX()).toRotationMatrix();
  Scene scene;
  scene.add(mapped(box({-2, -1, -1}, {0, 1, 0}), leaning(30)), true);
  scene.add(mapped(box({0, 0, 0}, {1, 0.5, 0.5}),
                   [&](const Vec3& p) { return leaning(20)(turn * p + Vec3(1e-3, 0, -0.008)); }));
  EXPECT_FALSE(come(scene, Vec3::UnitX()).points.empty());
  for (const ContactPoint& p : scene.contacts.points)
    EXPECT_GT(p.gap - p.initial_interference, 0) << p.normal.transpose();
}

TEST(SharpEdges, EdgesThatHaveComePastEachOtherAreDeep) {
  // Two bars across each other, each with an edge towards the other.
  const Mat3 along_x = Eigen::AngleAxisd(radians(45), Vec3::UnitX()).toRotationMatrix();
  const Mat3 along_y = Eigen::AngleAxisd(radians(135), Vec3::UnitY()).toRotationMatrix();
  Scene scene;
  scene.add(mapped(box({0, -1, 0}, {0.5, 1, 0.5}), [&](const Vec3& p) { return Vec3(along_y * p); }), true);
  scene.add(
      mapped(box({-1, 0, 0}, {1, 0.5, 0.5}), [&](const Vec3& p) { return Vec3(along_x * p - 0.008 * Vec3::UnitZ()); }));
  const ContactSet& contacts = come(scene, Vec3::UnitZ());
  ASSERT_EQ(contacts.points.size(), 1u);
  EXPECT_NEAR(contacts.points[0].gap - contacts.points[0].initial_interference, -0.008, 1e-12);
  expect_all_normals(contacts, -Vec3::UnitZ());
}

TEST(SharpEdges, AcuteEdgesThatCutThroughEachOtherAreDeep) {
  // Two blades of 40°, across each other, that lean by 65°: where their edges are nearest, each is before the other's
  // face, and yet they cut through each other.
  const Mat3 lean = Eigen::AngleAxisd(radians(65), Vec3::UnitY()).toRotationMatrix();
  const auto blade = [&](const Vec3& p) {
    return Vec3(lean * Vec3((2 * p.x() - 1) * std::tan(radians(20)) * p.z(), p.y(), p.z()));
  };
  const Mat3 over = Eigen::AngleAxisd(radians(180), Vec3::UnitX()).toRotationMatrix();
  const Mat3 across = Eigen::AngleAxisd(radians(90), Vec3::UnitZ()).toRotationMatrix();
  const Shape block = box({0, -1, 1e-3}, {1, 1, 1});
  Scene scene;
  scene.add(mapped(block, [&](const Vec3& p) { return Vec3(over * blade(p)); }), true);
  scene.add(mapped(block, [&](const Vec3& p) { return Vec3(across * blade(p) - 0.008 * Vec3::UnitZ()); }));
  const ContactSet& contacts = come(scene, Vec3::UnitZ());
  EXPECT_TRUE(std::any_of(contacts.points.begin(), contacts.points.end(),
                          [](const ContactPoint& p) { return p.gap - p.initial_interference < -5e-3; }));
}

TEST(SharpEdges, EdgesThatHaveComePastEachOtherBesideACornerAreDeep) {
  // A bar's edge crosses an upright one 6 mm below its upper end, rising at 45°: the middle of what lies behind both
  // adjacent faces of the upright one is above that end.
  const Vec3 apart(std::cos(radians(80)), std::sin(radians(80)), 0);
  Mat3 axes;  // along the bar's edge, and of its two faces
  axes.col(0) = (Vec3::UnitZ().cross(apart) + Vec3::UnitZ()).normalized();
  const Vec3 beside = axes.col(0).cross(apart);
  axes.col(1) = (apart - beside).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  Scene scene;
  scene.add(box({-1, -1, -1}, {0, 0, 0}), true);
  scene.add(mapped(box({-0.5, 0, 0}, {0.5, 0.5, 0.5}),
                   [&](const Vec3& p) { return Vec3(axes * p - 5e-3 * apart - 6e-3 * Vec3::UnitZ()); }));
  const ContactSet& contacts = come(scene, apart);
  EXPECT_TRUE(std::any_of(contacts.points.begin(), contacts.points.end(), [&](const ContactPoint& p) {
    return (p.normal + apart).norm() < 1e-9 && std::abs(p.gap - p.initial_interference + 5e-3) < 1e-9;
  }));
}

TEST(SharpEdges, AnEdgeThatHasComeThroughAFaceOfASlenderBarIsDeep) {
  // It comes out of the plane of that face far beside the bar: the middle of what lies behind both adjacent faces of
  // the bar's edge is beside it, too.
  const Mat3 down = (Eigen::AngleAxisd(0.03, Vec3::UnitY()) * Eigen::AngleAxisd(radians(45), Vec3::UnitX())).matrix();
  Scene scene;
  scene.add(box({-0.05, -0.5, -0.1}, {0.05, 0.5, 0}), true);
  scene.add(
      mapped(box({-0.5, 0, 0}, {0.5, 0.1, 0.1}), [&](const Vec3& p) { return Vec3(down * p - 5e-3 * Vec3::UnitZ()); }));
  const ContactSet& contacts = come(scene, Vec3::UnitZ());
  EXPECT_TRUE(std::any_of(contacts.points.begin(), contacts.points.end(), [](const ContactPoint& p) {
    return (p.normal + Vec3::UnitZ()).norm() < 0.05 && p.gap - p.initial_interference < -5e-3;
  }));
}

TEST(SharpEdges, EdgesOfTheMeshBehindASharpEdgeDoNotHoldWhatSlidesOverIt) {
  // A block whose front leans back slides over the joint of two slabs; the side of the second one bulges by a
  // millimetre, so that the edges of its mesh are convex ones.
  const auto bulging = [](const Vec3& p) {
    return Vec3(p.x() > 0 ? p : p - Vec3(4e-3 * (1 - p.y() * p.y()) * -p.z() * (1 + p.z()), 0, 0));
  };
  Scene scene;
  scene.add(mapped(box({0, -1, -1}, {2, 1, 0}, {1, 4, 4}), bulging), true);
  scene.add(mapped(box({-1, -0.55, -1e-5}, {4e-3, 0.55, 1 - 1e-5}),
                   [](const Vec3& p) { return Vec3(p - Vec3(0.2 * p.z(), 0, 0)); }));
  scene.add(box({-2, -1, -1}, {-2e-3, 1, 0}), true);
  come(scene, Vec3(-3e-3, 0, 0));
  EXPECT_FALSE(scene.contacts.points.empty());
  for (const ContactPoint& p : scene.contacts.points) EXPECT_NEAR(p.normal.x(), 0, 1e-9) << p.position.transpose();
}

TEST(SharpEdges, AnEdgeThatEndsInAConcaveCornerTouchesBesideIt) {
  // Of three arms that meet in a corner two lie over the top, 5e-5 m apart from it, and one hangs down beside the
  // block, with its edge 1e-3 m past the side.
  const double across = std::sqrt(0.5);
  Mat3 pose;
  pose << 0, -across, -across,  //
      0, -across, across,       //
      -1, 0, 0;
  const auto solid = [](int i, int j, int k) { return i + j + k <= 1; };
  Scene scene;
  scene.add(box({-3, -3, -3}, {0, 3, 0}), true);
  scene.add(mapped(cells({2, 2, 2}, solid),
                   [&](const Vec3& p) { return Vec3(pose * (p - Vec3::Ones()) + Vec3(-1e-3, 0, 5e-5)); }));
  int at_the_edge = 0;
  for (const ContactPoint& p : scene.detect(reach).points) {
    if ((p.normal + Vec3::UnitX()).norm() > 1e-9 || p.position.z() < -0.1) continue;
    EXPECT_NEAR(p.gap, -1e-3, 1e-9);
    ++at_the_edge;
  }
  EXPECT_EQ(at_the_edge, 1);
}

}  // namespace
}  // namespace talus
