#pragma once

#include <string>

#include "render/paint/image.hpp"
#include "render/paint/painter.hpp"
#include "render/stereonet/stereonet.hpp"

namespace talus {

/// The net with a title, if it is not empty, and a key beside it: sets with their means, densities, what belongs to the
/// slope, and how many poles and intersections are critical; without paper.
Painting stereonet_painting(const Stereonet& net, const std::string& title);

/// The same as an image. Throws InputError for sizes outside 320…8192.
Image draw_stereonet(const Stereonet& net, const std::string& title, int width = 1600, int height = 1000);

}  // namespace talus
