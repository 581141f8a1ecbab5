#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/units.hpp"
#include "unit/contact/blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::reach;
using testing::Scene;
using testing::Shape;
using testing::total_area;

/// A unit block of 3 × 3 cells at `offset` over a slab of 7 × 6 cells that do not match it.
Scene block_on_slab(const Vec3& offset, bool deformable_slab = false) {
  Scene scene;
  scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), !deformable_slab);
  scene.add(box(offset, offset + Vec3(1, 1, 1), {3, 3, 3}, true));
  return scene;
}

void expect_upward(const ContactSet& contacts) {
  for (const ContactPoint& p : contacts.points) {
    // The slab comes first, so normals point from the block down to it.
    EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 1e-12) << p.normal.transpose() << " key " << std::hex << p.key;
  }
}

void expect_sound(const ContactSet& contacts) {
  std::set<std::uint64_t> keys;
  for (const ContactPoint& p : contacts.points) {
    EXPECT_TRUE(keys.insert(p.key).second) << "key twice";
    EXPECT_NEAR(p.normal.norm(), 1, 1e-12);
    EXPECT_TRUE(std::isfinite(p.gap) && p.position.allFinite() && std::isfinite(p.normal_stiffness));
    EXPECT_GT(p.normal_stiffness, 0);
    double plus = 0, minus = 0;
    for (int i = p.stencil_begin; i < p.stencil_end; ++i) {
      (contacts.weights[i] > 0 ? plus : minus) += contacts.weights[i];
    }
    EXPECT_NEAR(plus, 1, 1e-12);
    EXPECT_NEAR(minus, -1, 1e-12);
  }
}

TEST(FaceFaceSearch, AreaIsThatBeforeBodiesSpread) {
  for (const bool finer_spreads : {true, false}) {
    Scene scene = block_on_slab({2, 1.5, -1e-6}, true);
    scene.detect(reach);
    const int spreads = finer_spreads ? 1 : 0;
    for (int i = 0; i < scene.node_count(spreads); ++i) scene.x[scene.first_node(spreads) + i].head<2>() *= 1.01;
    const ContactSet& contacts = scene.detect(reach);
    EXPECT_NEAR(total_area(contacts), 1, 1e-12) << "finer spreads: " << finer_spreads;
    expect_upward(contacts);
    expect_sound(contacts);
  }
}

TEST(FaceFaceSearch, AreaIsTheFacesAtEveryOffset) {
  for (double dx : {1.0, 1.1, 1 + 1.0 / 7, 10.0 / 7, 5.0 / 7 - 1e-9, 5.0 / 7 + 1e-13, 0.77, 2.2222}) {
    for (double dy : {1.0, 4.0 / 6, 1.2345, 2.0 - 1e-12, 8.0 / 6 - 1.0 / 3}) {
      Scene scene = block_on_slab({dx, dy, -1e-6});
      const ContactSet& contacts = scene.detect(reach);
      EXPECT_NEAR(total_area(contacts), 1, 1e-12) << dx << " " << dy;
      expect_upward(contacts);
      expect_sound(contacts);
      for (const ContactPoint& p : contacts.points) EXPECT_NEAR(p.gap, -1e-6, 1e-14);
    }
  }
}

TEST(FaceFaceSearch, AreaWeightsCarryALinearPressureAndTheMomentOfAUniformOne) {
  Scene scene = block_on_slab({1.234, 0.777, 0}, true);
  const Vec3 centre(1.734, 1.277, 0);
  const ContactSet& contacts = scene.detect(reach);
  double force = 0;
  Vec3 moment = Vec3::Zero();
  for (const ContactPoint& p : contacts.points) {
    const Vec3 arm = p.position - centre;
    force += p.area * (3 + 2 * arm.x() - 5 * arm.y());
    moment += p.area * arm;
  }
  EXPECT_NEAR(force, 3, 1e-12);
  EXPECT_LT(moment.norm(), 1e-12);
}

TEST(FaceFaceSearch, PlaneFacesOfSingleBodiesTouchAtTheCornersOfTheirOverlapAlone) {
  for (const bool single : {true, false}) {
    Scene scene;
    scene.single_body = single;
    scene.add(box({0, 0, 0}, {2, 2, 1}));
    scene.add(box({0.75, 1.5, 1 - 1e-6}, {1.75, 2.5, 2 - 1e-6}));
    const ContactSet& contacts = scene.detect(reach);
    EXPECT_NEAR(total_area(contacts), 0.5, 1e-12);
    expect_sound(contacts);
    Vec3 moment = Vec3::Zero();
    for (const ContactPoint& p : contacts.points) moment += p.area * (p.position - Vec3(1.25, 1.75, 1));
    EXPECT_LT(moment.head<2>().norm(), 1e-12);
    if (!single) {
      EXPECT_GT(contacts.points.size(), 4U) << "edges of the mesh cross";
      continue;
    }
    ASSERT_EQ(contacts.points.size(), 4U);
    for (const ContactPoint& p : contacts.points) EXPECT_NEAR(p.area, 0.125, 1e-12);
  }
}

TEST(FaceFaceSearch, NodesAmidAStraightEdgeOfASingleBodyTouchNothing) {
  for (int degrees = 0; degrees < 90; degrees += 7) {
    Scene scene;
    scene.single_body = true;
    scene.add(box({-2, -2, -1}, {2, 2, 0}, {2, 1, 1}));
    scene.add(box({-0.5, -0.5, -1e-6}, {0.5, 0.5, 1}, {2, 1, 1}));
    const Eigen::AngleAxisd turn(radians(degrees), Vec3::UnitZ());
    for (int i = 0; i < scene.node_count(1); ++i) {
      Vec3& node = scene.x[scene.first_node(1) + i];
      node = turn * node + Vec3(0.3, 0.1, 0);
    }
    const ContactSet& contacts = scene.detect(reach);
    expect_sound(contacts);
    EXPECT_EQ(contacts.points.size(), 4U) << "turned by " << degrees << "°";
    for (const ContactPoint& p : contacts.points) {
      EXPECT_NEAR(p.area, 0.25, 1e-9);
      const Vec3 own = turn.inverse() * (p.position - Vec3(0.3, 0.1, 0));
      EXPECT_LT((own.head<2>().cwiseAbs() - Eigen::Vector2d(0.5, 0.5)).norm(), 1e-9);
    }
  }
}

TEST(FaceFaceSearch, PlatesThinnerThanTheDepthTouchOnOneSide) {
  // Nodes amid the lower face of a plate lie 0.03 m above the lower face of the next: within the depth of a contact.
  Scene scene;
  scene.add(box({0, 0, 0}, {1, 0.6, 0.03}, {4, 2, 1}));
  scene.add(box({0.07, 0.01, 0.03 - 1e-6}, {1.07, 0.61, 0.06 - 1e-6}, {4, 2, 1}));
  const ContactSet& contacts = scene.detect(1e-3);
  EXPECT_NEAR(total_area(contacts), 0.93 * 0.59, 1e-9);
  for (const ContactPoint& p : contacts.points) {
    EXPECT_NEAR(p.gap, -1e-6, 1e-12);
    EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 1e-9);
  }
}

TEST(FaceFaceSearch, StencilsTurnARotationIntoTheRightGaps) {
  // Small tilts of the block about an axis in the joint: the gap at a point is the tilt times its arm.
  Scene scene = block_on_slab({1.234, 0.777, 0});
  const ContactSet contacts = scene.detect(reach);
  ASSERT_FALSE(contacts.points.empty());
  for (const ContactPoint& p : contacts.points) {
    double gap = p.gap;
    for (int i = p.stencil_begin; i < p.stencil_end; ++i) {
      if (contacts.nodes[i] < scene.first_node(1)) continue;
      gap += contacts.weights[i] * p.normal.dot(Vec3(0, 0, 1e-3 * (scene.x[contacts.nodes[i]].x() - 1)));
    }
    EXPECT_NEAR(gap, 1e-3 * (p.position.x() - 1), 1e-9);
  }
}

TEST(FaceFaceSearch, MatchingMeshesHaveOnePointForEachPairOfNodes) {
  Scene scene;
  scene.add(box({0, 0, 0}, {1, 1, 1}, {3, 3, 3}));
  scene.add(box({0, 0, 1}, {1, 1, 2}, {3, 3, 3}));
  const ContactSet& contacts = scene.detect(reach);
  EXPECT_NEAR(total_area(contacts), 1, 1e-12);
  expect_sound(contacts);
  expect_upward(contacts);
  // Diagonals of the two faces cross in every cell: 16 pairs of nodes and 9 crossings, or 16 alone.
  EXPECT_TRUE(contacts.points.size() == 25 || contacts.points.size() == 16) << contacts.points.size();
  for (const ContactPoint& p : contacts.points) EXPECT_GT(p.area, 1e-3);
}

TEST(FaceFaceSearch, StiffnessIsThePairs) {
  Scene scene = block_on_slab({1.1, 1.2, 0});
  const ContactSet& contacts = scene.detect(reach);
  double normal = 0, shear = 0;
  for (const ContactPoint& p : contacts.points) normal += p.normal_stiffness, shear += p.shear_stiffness;
  EXPECT_NEAR(normal, 10 * 1e9 / scene.size(1), 1);  // κE/h times 1 m²; the fixed slab is left out
  EXPECT_NEAR(shear, 0.4 * normal, 1);

  Scene both = block_on_slab({1.1, 1.2, 0}, true);
  normal = 0;
  for (const ContactPoint& p : both.detect(reach).points) normal += p.normal_stiffness;
  EXPECT_NEAR(normal, 10 * 0.5e9 / both.size(1), 1);

  Scene given = block_on_slab({1.1, 1.2, 0});
  given.laws[0].normal_stiffness = 5e6;
  given.laws[0].shear_stiffness = 3e6;
  normal = shear = 0;
  for (const ContactPoint& p : given.detect(reach).points) normal += p.normal_stiffness, shear += p.shear_stiffness;
  EXPECT_NEAR(normal, 5e6, 1e-3);
  EXPECT_NEAR(shear, 3e6, 1e-3);
}

TEST(FaceFaceSearch, TwoFlushSlabsHoldABlockWithUpwardNormalsOnly) {
  for (double dx : {1.5, 1.0, 2.0, 1.0 + 1.0 / 3, 1.7, 1.0 + 1e-7, 1.0 - 1e-7}) {
    for (double depth : {0.0, 1e-9, 1e-7, 1e-5}) {
      for (double step : {0.0, 1e-8, -1e-8}) {  // the second slab has settled by another amount
        Scene scene;
        scene.add(box({0, 0, -1}, {2, 3, 0}, {3, 4, 1}), true);
        scene.add(box({2, 0, -1}, {4, 3, step}, {2, 3, 1}), true);
        scene.add(box({dx, 1, -depth}, {dx + 1, 2, 1 - depth}, {3, 3, 3}, true));
        const ContactSet& contacts = scene.detect(reach);
        EXPECT_NEAR(total_area(contacts), 1, 2e-7) << dx << " " << depth;  // less a strip between two sharp edges
        expect_upward(contacts);
        expect_sound(contacts);
      }
    }
  }
}

TEST(FaceFaceSearch, SlidingOverInnerEdgesKeepsKeysAndMemory) {
  Scene scene = block_on_slab({1.0, 1.0, -1e-6});
  const Vec3 traction(-3, 0.5, 0);
  std::set<std::uint64_t> corners;
  for (int step = 0; step < 200; ++step) {
    const ContactSet& contacts = scene.detect(reach);
    Vec3 carried = Vec3::Zero();
    for (const ContactPoint& p : contacts.points) carried += p.shear_start;
    if (step > 0) {
      EXPECT_LT((carried - traction).norm(), 1e-9) << step;
      for (const ContactPoint& p : contacts.points) EXPECT_EQ(p.mode, ContactMode::slip);
    }
    std::set<std::uint64_t> now;
    for (const ContactPoint& p : contacts.points) {
      if (p.key >> 62 == 1 && static_cast<int>(p.key >> 31 & 0x7fffffff) >= scene.first_node(1)) now.insert(p.key);
    }
    EXPECT_EQ(now.size(), 16u);  // the block's nodes on the joint keep their names
    if (step > 0) {
      EXPECT_EQ(now, corners) << step;
    }
    corners = now;
    std::vector<ContactOutcome> outcomes(contacts.points.size());
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      outcomes[i].shear_force = traction * contacts.points[i].area;
      outcomes[i].slip = 0.007;
      scene.contacts.points[i].mode = ContactMode::slip;
      EXPECT_NEAR(contacts.points[i].slip_start, 0.007 * step, 1e-12);
    }
    scene.detector().accept(scene.contacts, outcomes);
    scene.move(1, {0.007, 0.003, 0});
  }
}

/// Where sharp edges of two faces that are not quite parallel cross, motion along either of them opens nothing.
TEST(FaceFaceSearch, SharpEdgesThatCrossSlideAlongEachOther) {
  const Mat3 r =
      (Eigen::AngleAxisd(radians(0.7), Vec3::UnitX()) * Eigen::AngleAxisd(radians(1.2), Vec3::UnitY())).matrix();
  Scene scene;
  scene.single_body = true;
  scene.add(box({-1, -0.1, -0.2}, {1, 0.1, 0}), true);
  scene.add(mapped(box({-0.1, -1, 0}, {0.1, 1, 0.2}), [&](const Vec3& p) { return Vec3(r * p); }));
  const ContactSet& contacts = scene.detect(reach);
  ASSERT_EQ(contacts.points.size(), 4u);
  for (const ContactPoint& p : contacts.points) {
    EXPECT_GT(p.area, 0);
    EXPECT_NEAR(p.normal.dot(Vec3::UnitX()), 0, 1e-12);
    EXPECT_NEAR(p.normal.dot(r.col(1)), 0, 1e-12);
    EXPECT_LT(p.normal.z(), 0);
  }
}

TEST(FaceFaceSearch, ReachIsRespected) {
  for (double gap : {0.0099, 0.0101}) {
    Scene scene = block_on_slab({1.1, 1.2, gap});
    EXPECT_NEAR(total_area(scene.detect(reach)), gap < reach ? 1.0 : 0.0, 1e-12);
    EXPECT_EQ(scene.contacts.points.empty(), gap > reach);
  }
}

TEST(FaceFaceSearch, ReachIsRespectedWhenCandidatesAreKept) {
  Scene scene = block_on_slab({1.1, 1.2, 0.0101});
  EXPECT_TRUE(scene.detect(reach).points.empty());
  scene.move(1, {0, 0, -0.0002});
  EXPECT_FALSE(scene.detect(reach).points.empty());
  scene.move(1, {0, 0, 0.0002});
  EXPECT_TRUE(scene.detect(reach).points.empty());
}

/// Everything about the contacts that must not depend on what was detected before.
std::vector<double> digits(const ContactSet& contacts) {
  std::vector<double> all;
  for (const ContactPoint& p : contacts.points) {
    all.insert(all.end(), {static_cast<double>(p.key % 1000003), p.gap, p.area, p.normal.x(), p.position.y()});
  }
  all.insert(all.end(), contacts.weights.begin(), contacts.weights.end());
  return all;
}

TEST(FaceFaceSearch, KeptCandidatesChangeNoBit) {
  Scene going = block_on_slab({1.0, 1.0, -1e-6});
  for (int step = 0; step < 40; ++step) {
    Scene fresh = block_on_slab({1.0, 1.0, -1e-6});
    fresh.x = going.x;
    EXPECT_EQ(digits(going.detect(reach)), digits(fresh.detect(reach))) << step;
    EXPECT_FALSE(going.contacts.points.empty()) << step;
    going.move(1, {0.013, 0.004, 0.0001});
  }
}

TEST(FaceFaceSearch, FarFromTheOrigin) {
  const Vec3 far(1e6, -1e6, 1e6);
  Scene scene;
  scene.add(box(far + Vec3(0, 0, -1), far + Vec3(5, 4, 0), {7, 6, 1}), true);
  scene.add(box(far + Vec3(1.1, 1.2, 0), far + Vec3(2.1, 2.2, 1), {3, 3, 3}, true));
  const ContactSet& contacts = scene.detect(reach);
  EXPECT_NEAR(total_area(contacts), 1, 1e-8);
  expect_sound(contacts);
  for (const ContactPoint& p : contacts.points) {
    EXPECT_NEAR(p.gap, 0, 1e-9);
    EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 1e-8);
  }
}

TEST(FaceFaceSearch, ATenthOfTheSizeGivesTheSameInRelation) {
  const auto at_scale = [](double s) {
    Scene scene;
    scene.add(box({0, 0, -s}, {5 * s, 4 * s, 0}, {7, 6, 1}), true);
    scene.add(box(s * Vec3(1.1, 1.2, -1e-5), s * Vec3(2.1, 2.2, 1), {3, 3, 3}, true));
    return std::pair(scene.detect(reach * s), s);
  };
  const auto [one, unit] = at_scale(1);
  const auto [tenth, scale] = at_scale(0.1);
  ASSERT_EQ(one.points.size(), tenth.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    EXPECT_EQ(one.points[i].key, tenth.points[i].key);
    EXPECT_NEAR(one.points[i].gap * scale, tenth.points[i].gap, 1e-14);
    EXPECT_NEAR(one.points[i].area * scale * scale, tenth.points[i].area, 1e-14);
    EXPECT_NEAR(one.points[i].normal_stiffness * scale, tenth.points[i].normal_stiffness, 1e-3);
  }
}

TEST(FaceFaceSearch, AnOverhangStandsOnWhatIsBelowIt) {
  for (double overhang : {0.25, 1.0 / 3, 0.5}) {
    for (double depth : {0.0, 1e-6, 1e-3}) {
      Scene scene;
      scene.add(box({0, 0, -1}, {2, 3, 0}, {3, 4, 2}), true);
      scene.add(box({1 + overhang, 1, -depth}, {2 + overhang, 2, 1 - depth}, {3, 3, 3}, true));
      std::vector<ContactOutcome> outcomes(scene.detect(reach).points.size());
      for (ContactOutcome& o : outcomes) o.gap = -depth;
      scene.detector().accept(scene.contacts, outcomes);
      const ContactSet& contacts = scene.detect(reach);
      EXPECT_NEAR(total_area(contacts), 1 - overhang, 1e-9);
      expect_upward(contacts);
    }
  }
}

TEST(FaceFaceSearch, StacksOfBlocksTouchTheirNeighboursAlone) {
  Scene scene;
  for (int i = 0; i < 4; ++i) scene.add(box(Vec3(0, 0, i), Vec3(1, 1, i + 1), {2, 2, 2}, i % 2), i == 0);
  const ContactSet& contacts = scene.detect(reach);
  EXPECT_NEAR(total_area(contacts), 3, 1e-12);
  for (const ContactPoint& p : contacts.points) EXPECT_EQ(p.bodies[1], p.bodies[0] + 1);
  EXPECT_TRUE(std::ranges::is_sorted(contacts.points, comes_before));
  EXPECT_TRUE(std::ranges::is_sorted(contacts.by_key, {}, [&](int i) { return contacts.points[i].key; }));
}

TEST(FaceFaceSearch, TwoFixedBodiesMakeNoContact) {
  Scene scene;
  scene.add(box({0, 0, 0}, {1, 1, 1}), true);
  scene.add(box({0, 0, 1}, {1, 1, 2}), true);
  EXPECT_TRUE(scene.detect(reach).points.empty());
  scene.detector().set_fixed({true, false});
  EXPECT_FALSE(scene.detect(reach).points.empty()) << "else they make one";
}

TEST(FaceFaceSearch, JointIsTheOneThatBothFacetsCarry) {
  for (const auto& [lower, upper, expected] : {std::array{1, 1, 1}, std::array{1, 2, 0}, std::array{-1, -1, 0}}) {
    Scene scene;
    scene.laws.assign(3, JointLaw{.friction = 0.5});
    for (const auto& [z, joint] : {std::pair(0, lower), std::pair(1, upper)}) {
      Shape shape = box(Vec3(0, 0, z), Vec3(1, 1, z + 1), {2, 2, 2});
      for (SurfaceTriangle& t : shape.triangles) t.joint = joint;
      scene.add(shape);
    }
    ASSERT_FALSE(scene.detect(reach).points.empty());
    for (const ContactPoint& p : scene.contacts.points) EXPECT_EQ(p.joint, expected);
  }
}

TEST(FaceFaceSearch, CoupledNodesHoldEveryStencilAndLastWhileSliding) {
  Scene scene = block_on_slab({1.0, 1.0, -1e-6}, true);
  std::uint64_t generation = 0;
  int changes = 0;
  for (int step = 0; step < 150; ++step) {
    const ContactSet& contacts = scene.detect(reach);
    const auto& pairs = scene.detector().coupled_nodes();
    EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
    for (const ContactPoint& p : contacts.points) {
      for (int i = p.stencil_begin; i < p.stencil_end; ++i) {
        for (int j = p.stencil_begin; j < p.stencil_end; ++j) {
          const std::pair<int, int> pair(contacts.nodes[i], contacts.nodes[j]);
          if (pair.first < pair.second) {
            EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), pair));
          }
        }
      }
    }
    changes += scene.detector().coupling_generation() != generation;
    generation = scene.detector().coupling_generation();
    scene.move(1, {0.007, 0.003, 0});  // three cells of the slab in all
  }
  EXPECT_LE(changes, 15);
  EXPECT_GE(changes, 1);
}

}  // namespace
}  // namespace talus
