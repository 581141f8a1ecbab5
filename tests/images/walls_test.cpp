// Fields of joints on the walls of joints: seen through the rock, or on blocks that are drawn apart.
#include <gtest/gtest.h>

#include "images/baseline.hpp"
#include "images/compare.hpp"
#include "images/test_scenes.hpp"
#include "render/fields/field_classes.hpp"
#include "render/paint/colour_map.hpp"
#include "render/scene/offscreen.hpp"

namespace talus {
namespace {

constexpr int walls_width = 900, walls_height = 600;

/// A contact point of the base of a box on the plate, at a corner of a unit square.
ContactSample corner_contact(int block, const Vec3& at, ContactState state, double stress, Bond bond) {
  return {.position = at,
          .normal = Vec3::UnitZ(),
          .blocks = {block, 0},
          .joint = 0,
          .state = state,
          .normal_force = stress * 0.25,
          .shear_force = Vec3(0.1 * stress, 0, 0),
          .area = 0.25,
          .friction = 0.5,
          .cohesion = bond == Bond::whole ? 1e5 : 0,
          .bond = bond};
}

/// Two boxes on a plate, the first pressed at one edge, the second lifted and gone along a little.
std::shared_ptr<Frame> pressed(const BlockSystem& system) {
  auto frame = std::make_shared<Frame>();
  frame->time = 2;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Vec3 by = b == 2 ? Vec3(0.3, 0, 0) : Vec3(Vec3::Zero());
    frame->displacement.resize(frame->displacement.size() + system.blocks[b].mesh.nodes.size(), by);
    frame->stress.resize(frame->stress.size() + system.blocks[b].mesh.tetrahedra.size(), Voigt::Zero());
  }
  frame->velocity.resize(frame->displacement.size(), Vec3::Zero());
  for (int i = 0; i < 4; ++i) {
    const Vec3 corner(i & 1, i >> 1, 0);
    frame->contacts.push_back(corner_contact(1, corner, ContactState::stick, i & 1 ? 8e4 : 1e4, Bond::whole));
    frame->contacts.push_back(corner_contact(2, corner + Vec3(1.3, 0, 0),
                                             i & 1 ? ContactState::slip : ContactState::open, 2e4, Bond::broken));
  }
  return frame;
}

Image picture_of(const char* field, double explosion, Theme theme = Theme::light) {
  const BlockSystem system = two_boxes();
  SceneSettings settings;
  settings.title = "Two boxes on a plate";
  settings.theme = theme;
  settings.field = field_named(field);
  settings.explosion = explosion;
  Scene scene(system, settings);
  scene.set_frame(pressed(system));
  scene.look(View::iso);
  return draw_image(scene, walls_width, walls_height);
}

TEST(WallImage, NormalStressIsSeenThroughTheRock) {
  const Image image = picture_of("joint.normal_stress", 0);
  for (const double t : {0.2, 0.5, 0.7}) EXPECT_TRUE(shows_lit(image, batlow().at(t))) << t;
  expect_baseline(image);
}

TEST(WallImage, StateHasWordsAndColoursOfItsClasses) {
  const Image image = picture_of("joint.state", 0);
  for (const FieldClass& each : classes_of(field_named("joint.state")))
    EXPECT_EQ(shows_lit(image, each.colour), each.word != "sticks") << each.word;
  expect_baseline(image);
}

TEST(WallImage, SlipOnBlocksThatAreDrawnApartInTheDark) {
  const Image image = picture_of("joint.slip", 0.8, Theme::dark);
  EXPECT_TRUE(shows_lit(image, batlow().at(1))) << "slip is the end of the legend";
  EXPECT_TRUE(shows_lit(image, colours(Theme::dark).rock));
  expect_baseline(image);
}

TEST(WallImage, WhatResultsOfEarlierVersionsLackIsSaidInThePicture) {
  const BlockSystem system = two_boxes();
  SceneSettings settings;
  settings.field = field_named("joint.bond");
  Scene scene(system, settings);
  const auto frame = pressed(system);
  for (ContactSample& contact : frame->contacts) contact.friction = std::numeric_limits<double>::quiet_NaN();
  scene.set_frame(frame);
  const Image image = draw_image(scene, walls_width, walls_height);
  EXPECT_FALSE(shows_lit(image, classes_of(*settings.field).back().colour, 1e-3));
  expect_baseline(image);
}

}  // namespace
}  // namespace talus
