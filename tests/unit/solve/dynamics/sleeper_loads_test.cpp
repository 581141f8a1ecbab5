#include "solve/dynamics/sleeper_loads.hpp"

#include <gmock/gmock.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double allowed = 1e-3;  // change, of all that presses
constexpr double above = 100;     // N, of the block above

/// On a fixed ground, body 0, stands a sleeper, body 1, and on it a block that is awake, body 2. Cubes of 1 m.
class LoadOnASleeper : public testing::Test {
 protected:
  LoadOnASleeper() {
    add(0, 1, Vec3(0, 0, 0), -2 * above);
    add(2, 1, Vec3(0, 0, 1), above);
    loads.fall_asleep(std::array{1}, bodies, contacts, outcomes);
    RestingContact on_ground{};
    on_ground.bodies[0] = 0;
    on_ground.bodies[1] = 1;
    on_ground.position = Vec3(0, 0, 0);
    on_ground.normal = Vec3::UnitZ();
    on_ground.normal_force = -2 * above;
    loads.set_resting(bodies, {on_ground});
    contacts.clear();
    outcomes.clear();
  }
  /// A vertical force on the first body, which presses the second by as much.
  void add(int first, int second, const Vec3& at, double force) {
    ContactPoint point{};
    point.bodies[0] = first;
    point.bodies[1] = second;
    point.position = at;
    point.normal = Vec3::UnitZ();
    contacts.points.push_back(point);
    outcomes.push_back({.normal_force = force});
  }
  std::vector<int> pressed() {
    return loads.pressed(bodies, contacts, {0, 1, 0},
                         [&](int i) { return Vec3(outcomes[i].normal_force * contacts.points[i].normal); });
  }

  Project project = test::rock_project(30, {});
  BlockSystem system = test::block_system({test::box_block("ground", Vec3(0, 0, -1), Vec3(9, 1, 0), BodyKind::fixed),
                                           test::box_block("sleeper", Vec3(0, 0, 0), Vec3(1, 1, 1)),
                                           test::box_block("awake", Vec3(0, 0, 1), Vec3(1, 1, 2))});
  BodySet bodies{project, system};
  ContactSet contacts;
  std::vector<ContactOutcome> outcomes;
  SleeperLoads loads{std::vector<double>(3, 1.0), allowed};
};

TEST_F(LoadOnASleeper, StaysWhereItIsPressedAsBefore) {
  add(2, 1, Vec3(0, 0, 1), above);
  EXPECT_THAT(pressed(), IsEmpty());
}

TEST_F(LoadOnASleeper, MayBeInOtherContacts) {
  add(2, 1, Vec3(-0.3, 0, 1), above / 2);
  add(2, 1, Vec3(0.3, 0, 1), above / 2);
  EXPECT_THAT(pressed(), IsEmpty());
}

TEST_F(LoadOnASleeper, MayChangeByLittleOfAllThatItBears) {
  add(2, 1, Vec3(0, 0, 1), above * (1 + 1.4 * allowed));
  EXPECT_THAT(pressed(), IsEmpty());
  contacts.clear();
  outcomes.clear();
  add(2, 1, Vec3(0, 0, 1), above * (1 + 1.6 * allowed));
  EXPECT_THAT(pressed(), ElementsAre(1));
}

TEST_F(LoadOnASleeper, MayNotMove) {
  add(2, 1, Vec3(0.01, 0, 1), above);
  EXPECT_THAT(pressed(), ElementsAre(1));
}

TEST_F(LoadOnASleeper, MayNotSqueezeItMore) {
  add(2, 1, Vec3(0, 0, 1), above);
  add(2, 1, Vec3(0, 0, 1), above);
  add(2, 1, Vec3(0, 0, 1), -above);
  EXPECT_THAT(pressed(), ElementsAre(1));
}

TEST_F(LoadOnASleeper, MayNotBeTakenAway) { EXPECT_THAT(pressed(), ElementsAre(1)); }

TEST_F(LoadOnASleeper, IsNotAskedForOfWhoIsAwake) {
  EXPECT_THAT(loads.pressed(bodies, contacts, {0, 0, 0}, [](int) { return Vec3(Vec3::Zero()); }), IsEmpty());
}

}  // namespace
}  // namespace talus
