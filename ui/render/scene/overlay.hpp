#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vector.hpp"
#include "render/paint/colour_map.hpp"
#include "render/paint/painter.hpp"
#include "render/paint/theme.hpp"
#include "render/scene/block_colours.hpp"

namespace talus {

/// A colour scale beside the picture. `low`, `high` in `unit`.
struct Legend {
  std::string title, unit;
  const ColourMap* map = nullptr;
  double low = 0, high = 1;
};

/// What the colours of blocks mean, under a title.
struct ColourKey {
  std::string title;
  std::vector<KeyEntry> entries;
};

/// What is written over a picture: title, legend and axes on the left, scale bar and time along the bottom.
struct Overlay {
  Theme theme = Theme::light;
  double text_height = 16;  ///< pixels; every other length is a multiple of it
  std::string title;
  std::string time;     ///< "t = 45.00 s"
  std::string remarks;  ///< beside the time: stage, exaggeration
  std::optional<Legend> legend;
  std::optional<ColourKey> colour_key{};  ///< in the legend's place
  std::string key_title{};                ///< "contacts"
  std::vector<KeyEntry> key{};            ///< of contact points and of what acts on the rock
  bool triad = true, scale_bar = true;
};

/// Text height for a picture of this size, pixels.
double automatic_text_height(double width, double height);

/// The part of the picture that is kept free for the rock.
PixelRect free_area(const Overlay& overlay, double width, double height);

/// What the overlay has to know of the camera.
struct OverlayView {
  double width = 0, height = 0;    ///< pixels
  Vec3 right, up, towards_viewer;  ///< unit
  double metres_per_pixel = 1;     ///< at the depth of the focal point
};

void paint(Painter& painter, const Overlay& overlay, const OverlayView& view);

}  // namespace talus
