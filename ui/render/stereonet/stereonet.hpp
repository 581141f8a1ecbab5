#pragma once

#include <optional>
#include <string>
#include <vector>

#include "orientation/critical_zone.hpp"
#include "orientation/pole_density.hpp"
#include "orientation/set_statistics.hpp"
#include "orientation/set_window.hpp"
#include "render/paint/theme.hpp"
#include "render/stereonet/net_shapes.hpp"

namespace talus {

/// What a stereonet of measured joints shows.
struct Stereonet {
  std::vector<MeasuredJoint> joints;
  Projection projection = Projection::equal_area;
  std::optional<DensityMethod> density;
  std::optional<KinematicSetting> slope;  ///< face, friction cone and critical zone are shown where it is given
  FailureMode mode = FailureMode::planar;
  bool great_circles = true;  ///< of the means of the sets
  std::optional<SetWindow> window;
  std::vector<std::size_t> selected;  ///< numbers of joints
  Theme theme = Theme::light;
  std::optional<Rgb> paper;  ///< what the net lies on; the theme's surface when absent
};

/// Colour and symbol of a set by its place in `statistics_by_set`: both differ from those of its neighbours.
Rgb set_colour(std::size_t set, Theme theme);
NetSymbol set_symbol(std::size_t set);

/// Colour of a band of density, 0 the lowest of `count`.
Rgb band_colour(std::size_t band, std::size_t count, Theme theme);

/// Colours of what belongs to the slope.
Rgb face_colour(Theme theme);
Rgb friction_colour(Theme theme);
Rgb zone_colour(Theme theme);

/// A net ready to be drawn, and the levels of its contours.
struct DrawnNet {
  std::vector<NetShape> shapes;
  std::vector<double> levels;
  double densest = 0;  ///< largest density, in the method's unit
  Vec3 densest_at = Vec3(0, 0, -1);
  std::size_t intersections = 0;  ///< of all pairs of joints, where the mode judges them
};

/// More intersections are a cloud that takes long to draw: only those of the sets' means are drawn then.
inline constexpr std::size_t most_intersections = 20000;

DrawnNet draw_net(const Stereonet& net);

}  // namespace talus
