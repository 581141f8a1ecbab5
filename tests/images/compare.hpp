#pragma once

#include <string>

#include "render/paint/image.hpp"

namespace talus {

/// How much two pictures of one size differ to the eye: the share of 4 × 4 pixel cells whose mean colour differs by
/// more than 10 of 255 in a channel. Averaging over cells forgives what differs between processors (software rendering
/// rounds edges and text by a pixel's fraction, SIMD widths differ); a block, a letter or a colour that is wrong fills
/// cells.
double difference(const Image& a, const Image& b);

constexpr double tolerated_difference = 0.002;

/// Compares with baselines/NAME.png of the running test's name; on a difference, or without a baseline, writes the
/// picture to the working folder and fails the test, saying where both are.
void expect_baseline(const Image& image);

/// Whether a surface of this colour is seen in any light: more than this share of the pixels has the colour, darkened
/// or brightened.
bool shows_lit(const Image& image, Rgb colour, double share = 2e-4);

/// How many pixels have exactly this colour, give or take 2 of 255.
int count_of(const Image& image, Rgb colour);

}  // namespace talus
