#include "render/paint/place_marks.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

const MarkedPicture picture{.text_height = 16, .width = 800, .height = 500};

bool overlap(const PixelRect& a, const PixelRect& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

void expect_inside(const PixelRect& place) {
  EXPECT_GT(place.width(), picture.text_height) << "wide enough for words";
  EXPECT_GT(place.height(), picture.text_height);
  EXPECT_GE(place.left, 0);
  EXPECT_LE(place.right, picture.width);
  EXPECT_GE(place.bottom, 0);
  EXPECT_LE(place.top, picture.height);
}

double middle(const PixelRect& place) { return (place.bottom + place.top) / 2; }

TEST(PlaceMarks, LabelsStandBesideTheirMarksInsideThePicture) {
  const std::vector<PlaceMark> marks{{{100, 250}, "base – cube"}, {{790, 480}, "another – one"}, {{400, 495}, "top"}};
  const auto places = label_places(marks, picture);
  ASSERT_EQ(places.size(), 3u);
  for (const PixelRect& place : places) expect_inside(place);
  EXPECT_GT(places[0].left, 100);
  EXPECT_LT(places[0].left, 100 + 2 * picture.text_height) << "clear of the ring, and no farther";
  EXPECT_NEAR(middle(places[0]), 250, 1e-9);
  EXPECT_LT(places[1].right, 790) << "to the left where the right has no room";
  EXPECT_GT(places[1].right, 790 - 2 * picture.text_height);
  EXPECT_NEAR(middle(places[1]), 480, 1e-9);
  EXPECT_LT(middle(places[2]), 495) << "lower where there is no room above";
  EXPECT_GT(middle(places[2]), 495 - 2 * picture.text_height);
}

TEST(PlaceMarks, LabelsOfMarksInOnePlaceDoNotOverlap) {
  std::vector<PlaceMark> marks;
  for (int i = 0; i < 5; ++i) marks.push_back({{400.0 + i, 250}, "block " + std::to_string(i)});
  const auto places = label_places(marks, picture);
  ASSERT_EQ(places.size(), 5u);
  for (std::size_t i = 0; i < places.size(); ++i) {
    expect_inside(places[i]);
    EXPECT_NEAR(middle(places[i]), 250, 5 * picture.text_height) << "near its mark";
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(places[i], places[k])) << i << ' ' << k;
  }
}

TEST(PlaceMarks, LabelsKeepOutOfWhatIsCovered) {
  MarkedPicture window = picture;
  window.covered = {{740, 200, 790, 490}};
  const std::vector<PlaceMark> marks{
      {{640, 300}, "base – cube"}, {{760, 300}, "under the tools"}, {{640, 100}, "free"}};
  const auto places = label_places(marks, window);
  ASSERT_EQ(places.size(), 3u);
  for (const PixelRect& place : places) {
    expect_inside(place);
    EXPECT_FALSE(overlap(place, window.covered[0]));
  }
  EXPECT_LT(places[0].right, 640) << "to the left where the right is covered";
  EXPECT_GT(places[2].left, 640);
}

TEST(PlaceMarks, WhatLiesOutsideThePictureHasNoLabel) {
  const std::vector<PlaceMark> marks{{{-20, 250}, "left"}, {{400, 501}, "above"}, {{400, 250}, "inside"}};
  const auto places = label_places(marks, picture);
  ASSERT_EQ(places.size(), 3u);
  EXPECT_EQ(places[0].width(), 0);
  EXPECT_EQ(places[1].width(), 0);
  expect_inside(places[2]);
}

}  // namespace
}  // namespace talus
