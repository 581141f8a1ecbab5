#include "solve/shocks.hpp"

#include <gtest/gtest.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

constexpr double length = 0.01;  // s

/// A rigid cube that moves along x with an acceleration, and comes to another in a step.
class ShocksTest : public testing::Test {
 protected:
  ShocksTest() : system_(test::cube_on_slab()), set_(project(), rigid(system_)), shocks_(set_) {
    step_.length = length;
    step_.mesh_size = 1;
    increment_ = Increment::Zero(set_.unknowns());
  }
  static Project project() { return test::rock_project(30, {}); }
  static BlockSystem& rigid(BlockSystem& system) {
    system.blocks[1].body = BodyKind::rigid;
    return system;
  }
  int centre() const { return set_.rigid[set_.bodies[1].rigid].centre; }
  Vec3& acceleration() { return set_.nodes.acceleration[centre()]; }

  void begin(double speed, double before) {
    set_.nodes.velocity[centre()] = {speed, 0, 0};
    acceleration() = {before, 0, 0};
  }
  /// The step that ends with this acceleration; whether it is taken anew.
  bool ends_with(double after) {
    const auto& [beta, gamma, alpha_m, alpha_f] = step_.integration;
    const Vec3 way = length * set_.nodes.velocity[centre()] +
                     length * length * ((0.5 - beta) * acceleration() + beta * Vec3(after, 0, 0));
    increment_.segment<3>(3 * set_.nodes.freedom[centre()]) = way;
    return shocks_.slacken(set_, step_, increment_);
  }
  /// The ground has pushed the cube as it never did before: it goes on without an acceleration.
  void strike() {
    ContactSet contacts;
    ContactPoint point{};
    point.bodies[1] = 1;
    point.normal = -Vec3::UnitZ();
    contacts.points = {point};
    shocks_.look(set_, contacts, {{.normal_force = 1e6}});
    shocks_.forget(set_);
  }

  BlockSystem system_;
  BodySet set_;
  Shocks shocks_;
  StepContext step_;
  Increment increment_;
};

TEST_F(ShocksTest, what_goes_on_as_it_did_is_left_alone) {
  begin(1, 10);
  EXPECT_FALSE(ends_with(10));
  EXPECT_FALSE(ends_with(9.99));
  EXPECT_FALSE(ends_with(30));
  EXPECT_EQ(acceleration().x(), 10);
}

TEST_F(ShocksTest, a_push_that_is_over_is_not_held_on_to) {
  for (const double after : {4.0, 1.0, 0.0, -1.0}) {
    begin(1, 10);
    EXPECT_TRUE(ends_with(after)) << after;
    EXPECT_NEAR(acceleration().x(), after, 1e-9);
    EXPECT_FALSE(ends_with(after)) << "it ends as it begins";
  }
}

TEST_F(ShocksTest, a_stiff_contact_that_swings_to_and_fro_is_damped_as_before) {
  begin(1, 300);
  EXPECT_FALSE(ends_with(-100));
}

TEST_F(ShocksTest, a_blow_that_dies_away_gives_nothing_back) {
  begin(0.02, 300);
  EXPECT_TRUE(ends_with(250));
}

TEST_F(ShocksTest, what_gives_back_little_of_what_a_cube_has_is_left_alone) {
  begin(20, 300);
  EXPECT_FALSE(ends_with(250));
}

TEST_F(ShocksTest, a_step_that_is_taken_anew_gives_back_less_still) {
  begin(1, 300);
  ASSERT_TRUE(ends_with(50));
  EXPECT_TRUE(ends_with(48)) << "1.2e-3 m²/s², of 1";
  EXPECT_FALSE(ends_with(47.99)) << "6e-6";
}

TEST_F(ShocksTest, what_was_struck_goes_on_with_the_acceleration_that_it_comes_to) {
  begin(1, 300);
  strike();
  EXPECT_EQ(acceleration(), Vec3(Vec3::Zero()));
  EXPECT_TRUE(ends_with(5));
  EXPECT_NEAR(acceleration().x(), 5, 1e-12);
  EXPECT_FALSE(ends_with(5)) << "once";
}

TEST_F(ShocksTest, the_rest_of_a_blow_does_not_throw_back) {
  begin(1, 300);
  strike();
  EXPECT_FALSE(ends_with(-150));
  EXPECT_EQ(acceleration(), Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace talus
