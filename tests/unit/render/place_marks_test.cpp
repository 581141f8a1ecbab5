#include "render/place_marks.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

constexpr MarkedPicture picture{.text_height = 16, .width = 800, .height = 500};

bool meet(const PixelRect& a, const PixelRect& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

TEST(PlaceMarks, LabelsStandBesideTheirMarksInsideThePicture) {
  const std::vector<PlaceMark> marks{{{100, 250}, "base – cube"}, {{790, 480}, "another – one"}};
  const auto places = label_places(marks, picture);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_GT(places[0].left, 100);
  EXPECT_NEAR((places[0].bottom + places[0].top) / 2, 250, 1e-9);
  EXPECT_LT(places[1].right, 790) << "to the left where the right has no room";
  EXPECT_LE(places[1].top, 500);
}

TEST(PlaceMarks, LabelsOfMarksInOnePlaceDoNotMeet) {
  std::vector<PlaceMark> marks;
  for (int i = 0; i < 5; ++i) marks.push_back({{400.0 + i, 250}, "block " + std::to_string(i)});
  const auto places = label_places(marks, picture);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(meet(places[i], places[k])) << i << ' ' << k;
}

TEST(PlaceMarks, WhatLiesOutsideThePictureHasNoLabel) {
  const std::vector<PlaceMark> marks{{{-20, 250}, "left"}, {{400, 501}, "above"}};
  for (const PixelRect& place : label_places(marks, picture)) EXPECT_EQ(place.width(), 0);
}

}  // namespace
}  // namespace talus
