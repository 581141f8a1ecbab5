#pragma once

#include "render/paint/image.hpp"

namespace talus {

/// How much of a picture differs to the eye from another one of its size: the share of its tiles that are not alike
/// enough (render/paint/picture_difference).
double difference(const Image& a, const Image& b);

/// Whether a surface of this colour is seen in any light: more than this share of the pixels has the colour, darkened
/// or brightened.
bool shows_lit(const Image& image, Rgb colour, double share = 2e-4);

/// How many pixels have exactly this colour, give or take 2 of 255.
int count_of(const Image& image, Rgb colour);

}  // namespace talus
