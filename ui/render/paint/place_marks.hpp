#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/paint/painter.hpp"
#include "render/paint/theme.hpp"

/// Places in a picture that the eye should go to.
namespace talus {

/// A place and the words beside it.
struct PlaceMark {
  PixelPoint at;
  std::string label;
};

/// What marks have to know of the picture they are painted over.
struct MarkedPicture {
  Theme theme = Theme::light;
  double text_height = 16;              ///< pixels; every other length is a multiple of it
  double width = 0, height = 0;         ///< pixels
  std::vector<PixelRect> covered = {};  ///< something else lies there: labels keep out of it
};

/// Where each label goes: beside its mark, inside the picture, none over another or where the picture is covered. Marks
/// outside the picture get an empty place and are not painted.
std::vector<PixelRect> label_places(std::span<const PlaceMark> marks, const MarkedPicture& picture);

/// The labels alone, each on a card beside its place; the first one is painted last, so that it lies on top.
void paint_labels(Painter& painter, std::span<const PlaceMark> marks, const MarkedPicture& picture);

/// A ring with a cross in the theme's warning colour at each place, and its label on a card; the first one is painted
/// last, so that it lies on top.
void paint_marks(Painter& painter, std::span<const PlaceMark> marks, const MarkedPicture& picture);

}  // namespace talus
