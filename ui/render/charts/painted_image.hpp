#pragma once

#include "render/paint/image.hpp"
#include "render/paint/painter.hpp"

namespace talus {

/// A picture of `width` × `height` pixels that `paint` draws on paper of that colour. It is told the size of what it
/// draws on, which is larger: several pixels are averaged to one. Throws InputError for sizes outside 320…8192.
Image painted_image(int width, int height, Rgb paper, const Painting& paint);

}  // namespace talus
