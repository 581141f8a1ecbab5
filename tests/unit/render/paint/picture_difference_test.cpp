#include "render/paint/picture_difference.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace talus {
namespace {

constexpr Rgb paper = rgb(0xd0d8e0), ink = rgb(0x203040);

void fill(Image& image, const PictureTile& tile, Rgb colour) {
  for (int y = tile.top; y < tile.top + tile.height; ++y)
    for (int x = tile.left; x < tile.left + tile.width; ++x) image.set(x, y, colour);
}

Image sheet(int width, int height, Rgb colour = paper) {
  Image image(width, height);
  fill(image, {0, 0, width, height}, colour);
  return image;
}

TEST(PictureDifference, OfEqualPicturesIsNone) {
  Image picture = sheet(100, 60);
  fill(picture, {13, 7, 31, 1}, ink);
  const PictureDifference found = compare_pictures(picture, picture, 1);
  EXPECT_EQ(found.similarity, 1);
  EXPECT_EQ(found.differing, 0);
  EXPECT_EQ(found.region.width, 0);
}

TEST(PictureDifference, IsFoundWhereItIs) {
  const Image empty = sheet(203, 107);
  Image marked = empty;
  fill(marked, {90, 40, 6, 1}, ink);  // as faint as a dash
  const PictureDifference found = compare_pictures(empty, marked);
  EXPECT_LT(found.similarity, alike_enough);
  EXPECT_GT(found.differing, 0);
  EXPECT_LT(found.differing, 10);
  EXPECT_LE(found.region.left, 90);
  EXPECT_GE(found.region.left + found.region.width, 96);
  EXPECT_LE(found.region.top, 40);
  EXPECT_LT(found.region.width, 50);
  EXPECT_LT(found.region.height, 50);
}

TEST(PictureDifference, IsFoundInTheLastCorner) {
  const Image empty = sheet(203, 107);
  Image marked = empty;
  fill(marked, {200, 104, 3, 3}, ink);
  const PictureDifference found = compare_pictures(empty, marked);
  EXPECT_LT(found.similarity, alike_enough);
  EXPECT_EQ(found.worst.left + found.worst.width, 203);
  EXPECT_EQ(found.worst.top + found.worst.height, 107);
}

TEST(PictureDifference, OfColoursAloneIsSeenFromFifteenLevelsOn) {
  const auto similarity = [](Rgb other) { return compare_pictures(sheet(64, 64), sheet(64, 64, other)).similarity; };
  EXPECT_GT(similarity(rgb(0xd2d6e2)), 0.98);
  EXPECT_GT(similarity(rgb(0xd0d8ec)), alike_enough);
  EXPECT_LT(similarity(rgb(0xd0d8d1)), alike_enough);
}

/// Both colours are equally light, and a picture in grey would show nothing.
TEST(PictureDifference, SeesALineThatOnlyItsColourTells) {
  const Image empty = sheet(64, 64, rgb(0x808080));
  Image line = empty;
  fill(line, {0, 30, 64, 3}, rgb(0xc06a80));
  EXPECT_LT(compare_pictures(empty, line).similarity, alike_enough);
}

TEST(PictureDifference, OfPicturesSmallerThanATileIsTold) {
  EXPECT_EQ(compare_pictures(sheet(5, 3), sheet(5, 3)).similarity, 1);
  EXPECT_LT(compare_pictures(sheet(5, 3), sheet(5, 3, ink)).similarity, alike_enough);
}

TEST(PictureDifference, OfTwoSizesIsRefused) {
  EXPECT_THROW(compare_pictures(sheet(64, 64), sheet(64, 63)), std::invalid_argument);
}

TEST(PictureDifference, IsDrawnBesideBothPictures) {
  const Image empty = sheet(120, 80);
  Image marked = empty;
  fill(marked, {50, 30, 20, 10}, ink);
  const Image picture = difference_picture(empty, marked);
  ASSERT_EQ(picture.width, 3 * 120 + 2 * 8);
  ASSERT_EQ(picture.height, 80);
  EXPECT_EQ(picture.at(60, 35), paper);
  EXPECT_EQ(picture.at(128 + 60, 35), ink);
  const Rgb there = picture.at(256 + 60, 35), elsewhere = picture.at(256 + 5, 5);
  EXPECT_GT(there.red, there.green + 60);
  EXPECT_EQ(elsewhere.red, elsewhere.green);
}

TEST(PictureDifference, IsFramedAlsoWhereItFillsThePicture) {
  const Image picture = difference_picture(sheet(40, 40), sheet(40, 40, ink));
  EXPECT_EQ(picture.at(96, 0), picture.at(picture.width - 1, 39)) << "corners of the frame";
}

}  // namespace
}  // namespace talus
