#include "render/stereonet/stereonet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "orientation/net_curves.hpp"
#include "render/paint/colour_map.hpp"
#include "render/paint/picture_words.hpp"
#include "render/stereonet/contour_bands.hpp"

namespace talus {
namespace {

constexpr int density_nodes = 121, zone_nodes = 201;
constexpr double around = 1.02;         // half the side of the square in which what lies beyond the rim is covered
constexpr double dash = 0.03;           // of a dashed line, in radii of the net
constexpr double most_full_poles = 60;  // more are drawn smaller, so that densities show between them

/// Puts the parts of a net on top of each other.
class Drawing {
 public:
  explicit Drawing(const Stereonet& net)
      : net_(net), colours_(colours(net.theme)), sets_(statistics_by_set(net.joints)) {}

  DrawnNet made() {
    add_density();
    add_zone();
    add_margin();
    add_grid();
    if (net_.slope && judges_lines(net_.mode)) add_intersections();
    add_slope();
    add_mean_planes();
    add_poles();
    add_window();
    add_rim();
    return std::move(drawn_);
  }

 private:
  Rgb paper() const { return net_.paper.value_or(colours_.surface); }

  Vec2 at(const Vec3& line) const { return projected(line, net_.projection); }

  std::vector<Vec2> flat(const NetCurve& curve) const {
    std::vector<Vec2> points;
    for (const Vec3& line : curve) points.push_back(at(line));
    return points;
  }

  void line(std::vector<Vec2> points, Rgb colour, double width) {
    drawn_.shapes.push_back(NetLine{std::move(points), colour, width});
  }

  void dashed(const std::vector<Vec2>& points, Rgb colour, double width) {
    double drawn = 0;  // along the curve
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double length = (points[i] - points[i - 1]).norm();
      double from = 0;
      while (from < length) {
        const double phase = std::fmod(drawn + from, 2 * dash);
        const double to = std::min(length, from + std::max(1e-6, (phase < dash ? dash : 2 * dash) - phase));
        const Vec2 along = (points[i] - points[i - 1]) / length;
        if (phase < dash) line({points[i - 1] + along * from, points[i - 1] + along * to}, colour, width);
        from = to;
      }
      drawn += length;
    }
  }

  void fill(std::vector<NetPolygon> region, Rgb colour, double opacity) {
    for (NetPolygon& polygon : region) drawn_.shapes.push_back(NetFill{std::move(polygon), colour, opacity});
  }

  void add_density() {
    if (!net_.density || net_.joints.empty()) return;
    const PoleDensity density(poles_of(net_.joints), *net_.density);
    const DensityGrid grid = density_grid(density, net_.projection, density_nodes);
    drawn_.levels = contour_levels(*net_.density, grid.largest);
    drawn_.densest = grid.largest;
    drawn_.densest_at = grid.densest;
    const std::size_t count = drawn_.levels.size();
    for (std::size_t i = 0; i < count; ++i)
      fill(region_above(grid.values, grid.size, drawn_.levels[i]), band_colour(i, count, net_.theme), 1);
    for (std::size_t i = 0; i < count; ++i)
      for (NetPolygon& piece : contour_lines(grid.values, grid.size, drawn_.levels[i]))
        line(std::move(piece), mix(band_colour(i, count, net_.theme), colours_.edge, 0.35), 0.7);
  }

  void add_zone() {
    if (!net_.slope) return;
    std::vector<double> margins;
    for (int row = 0; row < zone_nodes; ++row)
      for (int column = 0; column < zone_nodes; ++column) {
        const Vec2 place(2.0 * column / (zone_nodes - 1) - 1, 2.0 * row / (zone_nodes - 1) - 1);
        margins.push_back(critical_margin(unprojected(place, net_.projection), net_.mode, *net_.slope));
      }
    fill(region_above(margins, zone_nodes, 0), zone_colour(net_.theme), 0.22);
    for (NetPolygon& piece : contour_lines(margins, zone_nodes, 0))
      line(std::move(piece), zone_colour(net_.theme), 1.2);
  }

  /// Covers what was drawn beyond the rim: densities and zones are of the square around it. Nothing farther away is
  /// touched, for a net may stand below other words.
  void add_margin() {
    constexpr int pieces = 360;  // the corners of the square are among them
    for (int i = 0; i < pieces; ++i) {
      const auto ray = [](int k) {
        const double angle = 2 * std::numbers::pi * k / pieces;
        return Vec2(std::cos(angle), std::sin(angle));
      };
      const auto edge = [&](int k) { return Vec2(around * ray(k) / ray(k).cwiseAbs().maxCoeff()); };
      drawn_.shapes.push_back(NetFill{{ray(i), edge(i), edge(i + 1), ray(i + 1)}, paper(), 1});
    }
  }

  /// The net of Schmidt or Wulff: planes that strike north, and circles about north, every 10°.
  void add_grid() {
    const Rgb colour = mix(colours_.grid, colours_.line, 0.25);
    const auto width = [](int angle) { return angle % 30 == 0 ? 0.7 : 0.4; };
    for (int angle = 10; angle < 90; angle += 10) {
      for (const double direction : {90.0, 270.0})
        line(flat(great_circle({static_cast<double>(angle), direction})), colour, width(angle));
      for (const double north : {0.0, 180.0})
        line(flat(half_circle_about(direction_of({north, 0}), angle)), colour, width(angle));
    }
    line({{-1, 0}, {1, 0}}, colour, 0.7);
    line({{0, -1}, {0, 1}}, colour, 0.7);
  }

  /// The lower half of the circle about a level axis.
  static NetCurve half_circle_about(const Vec3& axis, double angle) {
    const Vec3 side(axis.y(), -axis.x(), 0), down(0, 0, -1);
    NetCurve curve;
    constexpr int pieces = 60;
    for (int i = 0; i <= pieces; ++i) {
      const double turn = std::numbers::pi * i / pieces;
      curve.push_back(std::cos(radians(angle)) * axis +
                      std::sin(radians(angle)) * (std::cos(turn) * side + std::sin(turn) * down));
    }
    return curve;
  }

  void add_slope() {
    if (!net_.slope) return;
    const KinematicSetting& slope = *net_.slope;
    const PlaneAttitude& face = slope.face;
    line(flat(great_circle(face)), face_colour(net_.theme), 2);
    // About the vertical: poles outside φ, lines inside 90° − φ are of what is steeper than φ.
    if (net_.mode == FailureMode::planar || net_.mode == FailureMode::wedge) {
      const double cone = net_.mode == FailureMode::wedge ? 90 - slope.friction_angle : slope.friction_angle;
      for (const NetCurve& curve : small_circle(Vec3(0, 0, -1), cone))
        dashed(flat(curve), friction_colour(net_.theme), 1.4);
    }
    if (net_.mode == FailureMode::planar) line(flat(daylight_envelope(face)), face_colour(net_.theme), 1.2);
    if (net_.mode == FailureMode::flexural && face.dip > slope.friction_angle)
      dashed(flat(great_circle({face.dip - slope.friction_angle, face.dip_direction})), friction_colour(net_.theme),
             1.4);
    if (net_.mode != FailureMode::wedge) add_limits(slope);
  }

  /// Straight lines at both sides of where planes or lines are counted.
  void add_limits(const KinematicSetting& slope) {
    const double towards = slope.face.dip_direction + (net_.mode == FailureMode::flexural ? 0 : 180);
    for (const double side : {-slope.lateral_limit, slope.lateral_limit})
      dashed({Vec2(0, 0), at(direction_of({towards + side, 0}))}, face_colour(net_.theme), 0.8);
  }

  void add_mean_planes() {
    if (!net_.great_circles) return;
    for (std::size_t i = 0; i < sets_.size(); ++i)
      line(flat(great_circle(sets_[i].mean_plane())), set_colour(i, net_.theme), 1.6);
  }

  void add_intersections() {
    std::vector<PlaneAttitude> planes, means;
    for (const MeasuredJoint& joint : net_.joints) planes.push_back(joint.plane);
    for (const SetStatistics& set : sets_) means.push_back(set.mean_plane());
    drawn_.intersections = planes.size() * (planes.size() - 1) / 2;
    if (drawn_.intersections <= most_intersections)
      add_lines(kinematic_check(planes, *net_.slope), NetSymbol::diamond, 0.3);
    add_lines(kinematic_check(means, *net_.slope), NetSymbol::cross, 1);
  }

  void add_lines(const KinematicResult& result, NetSymbol symbol, double size) {
    for (const IntersectionFindings& found : result.intersections) {
      const bool critical = net_.mode == FailureMode::wedge ? found.wedge : found.direct;
      const Rgb colour = critical ? zone_colour(net_.theme) : colours_.muted;
      drawn_.shapes.push_back(NetMarker{at(direction_of(found.line)), symbol, colour, paper(), size});
    }
  }

  void add_poles() {
    const auto count = static_cast<double>(std::max<std::size_t>(1, net_.joints.size()));
    const double size = std::clamp(std::sqrt(most_full_poles / count), 0.45, 1.0);
    for (std::size_t i = 0; i < sets_.size(); ++i)
      for (const std::size_t member : sets_[i].members)
        drawn_.shapes.push_back(
            NetMarker{at(pole_of(net_.joints[member].plane)), set_symbol(i), set_colour(i, net_.theme), paper(), size});
    for (const std::size_t member : net_.selected) {
      const Vec2 centre = at(pole_of(net_.joints.at(member).plane));
      std::vector<Vec2> ring;
      for (int i = 0; i <= 36; ++i)
        ring.push_back(centre + 0.035 * Vec2(std::cos(radians(10 * i)), std::sin(radians(10 * i))));
      line(ring, colours_.pick, 2);
    }
  }

  void add_window() {
    if (!net_.window) return;
    for (const NetCurve& curve : window_outline(*net_.window)) line(flat(curve), colours_.pick, 1.6);
  }

  void add_rim() {
    std::vector<Vec2> rim;
    for (int i = 0; i <= 360; ++i) rim.emplace_back(std::sin(radians(i)), std::cos(radians(i)));
    line(rim, colours_.text, 1.5);
    for (int azimuth = 0; azimuth < 360; azimuth += 10) {
      const Vec2 ray(std::sin(radians(azimuth)), std::cos(radians(azimuth)));
      line({ray, (azimuth % 30 == 0 ? 1.03 : 1.015) * ray}, colours_.text, 1);
      const char* const main[] = {"N", "E", "S", "W"};
      if (azimuth % 90 == 0)
        drawn_.shapes.push_back(NetWord{1.085 * ray, picture_word(main[azimuth / 90]), colours_.text, true});
      else if (azimuth % 30 == 0)
        drawn_.shapes.push_back(NetWord{1.085 * ray, std::to_string(azimuth), colours_.muted, false});
    }
    line({{-0.015, 0}, {0.015, 0}}, colours_.text, 1);
    line({{0, -0.015}, {0, 0.015}}, colours_.text, 1);
  }

  const Stereonet& net_;
  const ThemeColours& colours_;
  std::vector<SetStatistics> sets_;
  DrawnNet drawn_;
};

}  // namespace

Rgb set_colour(std::size_t set, Theme theme) {
  const auto& palette = curve_palette(theme);
  return palette[set % palette.size()];
}

NetSymbol set_symbol(std::size_t set) {
  constexpr NetSymbol symbols[] = {NetSymbol::disc, NetSymbol::square, NetSymbol::triangle, NetSymbol::diamond,
                                   NetSymbol::inverted_triangle};
  return symbols[set % std::size(symbols)];
}

Rgb band_colour(std::size_t band, std::size_t count, Theme theme) {
  const double share = count > 1 ? static_cast<double>(band) / static_cast<double>(count - 1) : 0.5;
  // From near the paper to far from it, so that what is dense stands out in both themes.
  // Batlow's pink end is left out: critical zones have it; its dark one is no lighter than a dark paper.
  return theme == Theme::light ? mix(batlow().at(0.72 - 0.62 * share), rgb(0xffffff), 0.55 * (1 - share))
                               : batlow().at(0.2 + 0.54 * share);
}

Rgb face_colour(Theme theme) { return colours(theme).text; }
Rgb friction_colour(Theme theme) { return theme == Theme::light ? rgb(0x2b5f2b) : rgb(0x8fce8f); }
Rgb zone_colour(Theme theme) { return theme == Theme::light ? rgb(0xc0143c) : rgb(0xff7a90); }

DrawnNet draw_net(const Stereonet& net) { return Drawing(net).made(); }

}  // namespace talus
