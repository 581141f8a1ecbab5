#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "base/units.hpp"
#include "contact/detection/missed_contacts.hpp"
#include "support/solver_scenes.hpp"
#include "unit/contact/blocks.hpp"

/// Contacts at the end of a step that nothing at its start told of.
namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::Scene;

/// A cube over a slab, rotated about its lower edge along y until its lower right corners are in the slab.
class MissedContact : public ::testing::Test {
 protected:
  MissedContact() {
    scene_.add(box({-3, -3, -1}, {3, 3, 0}), true);
    scene_.add(box({0, 0, 0.1}, {1, 1, 1.1}));
    end_ = scene_.x;
    const Mat3 turn = Eigen::AngleAxisd(std::asin(0.12), Vec3::UnitY()).toRotationMatrix();
    for (int i = 0; i < scene_.node_count(1); ++i) {
      Vec3& p = end_[scene_.first_node(1) + i];
      p = turn * (p - Vec3(0, 0, 0.1)) + Vec3(0, 0, 0.1);
    }
  }
  Scene scene_;
  std::vector<Vec3> end_;
  /// What looks ahead: the slab stays, the cube goes by `mean`, and its nodes by no more than `beside` beside that [m].
  static Reach ahead(double beside, const Vec3& mean = Vec3::Zero()) {
    Reach reach(0.5);
    reach.ways = {{}, {mean, beside}};
    return reach;
  }
  const Reach reach_ = ahead(0.1);
};

TEST_F(MissedContact, WhatRotatesIntoAnotherIsFoundWithItsDepth) {
  scene_.detect(0.01);
  const auto missed = scene_.detector().missed_contacts(scene_.x, end_, reach_, 1e-3);
  ASSERT_FALSE(missed.empty());
  double deepest = 0;
  for (const ContactDetector::MissedContact& contact : missed) {
    EXPECT_EQ(contact.bodies[0], 0);
    EXPECT_EQ(contact.bodies[1], 1);
    EXPECT_NEAR(contact.position.x(), std::sqrt(1 - 0.12 * 0.12), 0.03);
    deepest = std::max(deepest, contact.depth);
  }
  EXPECT_NEAR(deepest * scene_.size(1), 0.02, 1e-3);
}

TEST_F(MissedContact, WhatTheStepKnowsIsSaid) {
  const ContactSet& known = scene_.detect(0.2);
  ASSERT_FALSE(known.points.empty());
  const auto missed = scene_.detector().missed_contacts(scene_.x, end_, reach_, 1e-3);
  ASSERT_FALSE(missed.empty());
  for (const ContactDetector::MissedContact& contact : missed) {
    ASSERT_GE(contact.given, 0);
    EXPECT_LT((known.points[contact.given].position - contact.position).norm(), 0.13);
  }
}

TEST_F(MissedContact, WhatIsNotSoDeepIsNot) {
  scene_.detect(0.01);
  EXPECT_TRUE(scene_.detector().missed_contacts(scene_.x, end_, reach_, 0.1).empty());
}

TEST_F(MissedContact, WhatIsTakenInIsAsDeepWhereTheStepLeadsAsItIsThere) {
  ASSERT_TRUE(scene_.detect(0.01).points.empty());
  const auto missed = scene_.detector().missed_contacts(scene_.x, end_, reach_, 1e-3);
  scene_.detector().take_in(missed, scene_.x, scene_.contacts);
  ASSERT_EQ(scene_.contacts.points.size(), missed.size());
  double deepest = 0, deepest_missed = 0;
  for (const auto& contact : missed) deepest_missed = std::max(deepest_missed, contact.depth * contact.size);
  for (const ContactPoint& p : scene_.contacts.points) {
    double gap = p.gap;
    for (int k = p.stencil_begin; k < p.stencil_end; ++k) {
      const int node = scene_.contacts.nodes[k];
      gap += scene_.contacts.weights[k] * p.normal.dot(end_[node] - scene_.x[node]);
    }
    EXPECT_GT(p.gap, 0) << "it was no contact at the start";
    EXPECT_EQ(p.initial_interference, 0);
    deepest = std::max(deepest, -gap);
  }
  EXPECT_NEAR(deepest, deepest_missed, 1e-12);
  for (const auto& contact : scene_.detector().missed_contacts(scene_.x, end_, reach_, 1e-3))
    EXPECT_GE(contact.given, 0);
}

TEST_F(MissedContact, NobodyLooksForTheOneOfBlocksOfWhichNeitherRotates) {
  scene_.detect(0.01);
  const Reach hardly = ahead(0.9e-3 * scene_.size(1));
  EXPECT_TRUE(scene_.detector().missed_contacts(scene_.x, end_, hardly, 1e-3).empty());
}

TEST_F(MissedContact, OfBlocksThatNeitherRotateItIsFoundWhereTheyWentFartherThanTheStepReached) {
  scene_.detect(0.01);
  const Reach far = ahead(0, Vec3(0, 0, -0.02));
  EXPECT_FALSE(scene_.detector().missed_contacts(scene_.x, end_, far, 1e-3).empty());
  scene_.detect(0.03);
  EXPECT_TRUE(scene_.detector().missed_contacts(scene_.x, end_, far, 1e-3).empty());
}

TEST_F(MissedContact, WhatIsTakenInStaysHoweverFarApartItWas) {
  scene_.detect(1e-4);
  const auto missed = scene_.detector().missed_contacts(scene_.x, end_, reach_, 1e-3);
  ASSERT_FALSE(missed.empty());
  scene_.detector().take_in(missed, scene_.x, scene_.contacts);
  ASSERT_EQ(scene_.contacts.points.size(), missed.size());
  for (const ContactPoint& p : scene_.contacts.points) EXPECT_GT(p.gap, 1e-4);
}

TEST_F(MissedContact, LookingAheadChangesNothingThatIsFoundAtTheStart) {
  const ContactSet before = scene_.detect(0.2);
  scene_.detector().missed_contacts(scene_.x, end_, reach_, 1e-3);
  const ContactSet& after = scene_.detect(0.2);
  ASSERT_EQ(after.points.size(), before.points.size());
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    EXPECT_EQ(after.points[i].key, before.points[i].key);
    EXPECT_EQ(after.points[i].gap, before.points[i].gap);
    EXPECT_EQ(after.points[i].normal, before.points[i].normal);
  }
}

/// A rigid box, its corners at `lower` and `upper` [m], above a fixed slab, 1 m thick, whose top is at z = 0 and
/// reaches to x = `end`.
class BoxOverSlab {
 public:
  BoxOverSlab(const Vec3& lower, const Vec3& upper, double end)
      : system_(test::block_system({test::box_block("slab", Vec3(-3, -3, -1), Vec3(end, 3, 0), BodyKind::fixed),
                                    test::box_block("box", lower, upper, BodyKind::rigid)})),
        set_(test::rock_project(30, {{"fall", StageKind::dynamic, 0.01, 1, {}}}), system_) {
    for (const Block& block : system_.blocks) surfaces_.push_back(make_surface(block.mesh.nodes, block.surface));
    detector_ = std::make_unique<ContactDetector>(
        std::vector<ContactBody>{{&surfaces_[0], set_.bodies[0].first_node, true, 5e9, true},
                                 {&surfaces_[1], set_.bodies[1].first_node, false, 5e9, true}},
        std::vector<JointLaw>{{.friction = 0.5}}, PairJoints(), ContactSettings{});
  }

  /// Those of a step that knows what is found with the box higher by this [m].
  std::vector<ContactDetector::MissedContact> missed(double higher, const Increment& d) {
    std::vector<Vec3> positions = set_.nodes.position;
    for (int n = 0; n < set_.bodies[1].node_count; ++n) positions[set_.bodies[1].first_node + n].z() += higher;
    detector_->detect(positions, 0.1, known_);
    ContactLinks links(set_, known_);
    links.connect();
    MissedContacts missed(set_);
    const auto all = missed.seek(*detector_, links, d, 0.1, 1e-3, 0);
    return {all.begin(), all.end()};
  }
  const ContactSet& known() const { return known_; }
  double radius() const { return set_.rigid[0].radius; }

 private:
  BlockSystem system_;
  BodySet set_;
  std::vector<Surface> surfaces_;
  std::unique_ptr<ContactDetector> detector_;
  ContactSet known_;
};

/// A cube `height` [m] above the slab, or in it, of which no contact is known; it goes by `way` [m].
std::vector<ContactDetector::MissedContact> missed_by(double height, const Vec3& way) {
  BoxOverSlab scene(Vec3(0, 0, height), Vec3(1, 1, 1 + height), 3);
  Increment d = Increment::Zero(6);
  d.head<3>() = way;
  d[5] = 0.01;  // it rotates about the vertical: of blocks that do not, nobody looks for any
  auto missed = scene.missed(5, d);
  EXPECT_TRUE(scene.known().points.empty());
  return missed;
}

TEST(MissedContacts, WhatComesInDuringAStepIsMissed) {
  const auto missed = missed_by(0.01, {0, 0, -0.02});
  ASSERT_EQ(missed.size(), 4u);
  for (const auto& contact : missed) EXPECT_NEAR(contact.depth * contact.size, 0.01, 1e-12);
}

TEST(MissedContacts, WhatLayDeeperBeforeItIsNot) {
  EXPECT_TRUE(missed_by(-0.01, {0, 0, -0.005}).empty());
  EXPECT_TRUE(missed_by(-0.01, {0, 0, 0}).empty());
  EXPECT_TRUE(missed_by(-0.01, {0.03, 0.02, 0.001}).empty()) << "what slides along does not come in";
}

/// A bar reaches over the rim of the slab. It turns about its left end, the right one down, and goes back by 0.1 m:
/// what comes over the rim by then is deeper than what was over it.
TEST(MissedContacts, WhatTouchesInAnotherPlaceByTheEndIsMissed) {
  constexpr double gap = 0.018, angle = 0.02;
  BoxOverSlab scene(Vec3(-1, 0, gap), Vec3(1, 0.2, gap + 0.2), 0);
  Increment d = Increment::Zero(6);
  d.head<3>() = Vec3(-0.1, 0, -angle);
  d[4] = scene.radius() * angle;
  const auto missed = scene.missed(0, d);
  ASSERT_EQ(missed.size(), 2u);
  for (const ContactDetector::MissedContact& contact : missed) {
    EXPECT_GE(contact.given, 0);
    EXPECT_NEAR(contact.position.x(), 0, 1e-9);
    EXPECT_NEAR(contact.depth * contact.size, 1.1 * angle - gap, 1e-4);
  }
  d[0] = 0;
  EXPECT_TRUE(scene.missed(0, d).empty()) << "in the same place the step knows how deep they are";
}

}  // namespace
}  // namespace talus
