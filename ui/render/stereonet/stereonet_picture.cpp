#include "render/stereonet/stereonet_picture.hpp"

#include <algorithm>

#include "render/charts/painted_image.hpp"
#include "render/paint/numbers.hpp"
#include "render/paint/painter.hpp"
#include "render/paint/picture_words.hpp"
#include "render/stereonet/slope_key.hpp"

namespace talus {
namespace {

constexpr double hairline = 0.06, marker_radius = 0.3;  // in text heights
constexpr double room_for_words = 1.14;                 // radii that a net with its azimuths takes
constexpr double legend_row = 1.5, room_for_sample = 1.9;

/// Draws shapes on a net of `radius` pixels about `centre`.
class NetPainter {
 public:
  NetPainter(Painter& painter, PixelPoint centre, double radius, double em)
      : painter_(painter), centre_(centre), radius_(radius), em_(em) {}

  void operator()(const NetFill& shape) const { painter_.fill(pixels(shape.corners), shape.colour, shape.opacity); }
  void operator()(const NetLine& shape) const {
    painter_.line(pixels(shape.points), hairline * em_ * shape.width, shape.colour);
  }
  void operator()(const NetMarker& shape) const {
    paint_symbol(at(shape.at), shape.symbol, shape.colour, shape.rim, marker_radius * em_ * shape.size);
  }
  void operator()(const NetWord& shape) const {
    painter_.text(at(shape.at), shape.text,
                  {.height = shape.strong ? 1.1 * em_ : 0.8 * em_,
                   .colour = shape.colour,
                   .weight = shape.strong ? FontWeight::semibold : FontWeight::regular,
                   .x = AlignX::centre,
                   .y = AlignY::centre});
  }

  /// With a rim, so that it is seen on any density.
  void paint_symbol(PixelPoint middle, NetSymbol symbol, Rgb colour, Rgb rim, double size) const {
    for (const double grown : {1.0 + hairline * em_ / size, 1.0})
      for (const std::vector<Vec2>& part : symbol_outline(symbol)) {
        std::vector<PixelPoint> corners;
        for (const Vec2& corner : part)
          corners.push_back({middle.x + grown * size * corner.x(), middle.y + grown * size * corner.y()});
        painter_.fill(corners, grown > 1 ? rim : colour);
      }
  }

 private:
  PixelPoint at(const Vec2& place) const { return {centre_.x + radius_ * place.x(), centre_.y + radius_ * place.y()}; }
  std::vector<PixelPoint> pixels(const std::vector<Vec2>& places) const {
    std::vector<PixelPoint> points;
    for (const Vec2& place : places) points.push_back(at(place));
    return points;
  }

  Painter& painter_;
  PixelPoint centre_;
  double radius_, em_;
};

/// What is written beside the net, from top to bottom.
class Key {
 public:
  Key(Painter& painter, const Stereonet& net, PixelPoint top_left, double width, double em)
      : painter_(painter), net_(net), colours_(colours(net.theme)), at_(top_left), width_(width), em_(em) {}

  void paint(const DrawnNet& drawn) {
    paint_sets();
    if (!drawn.levels.empty()) paint_density(drawn);
    if (net_.slope) {
      paint_slope(drawn);
      paint_counts(*net_.slope);
    }
  }

 private:
  void heading(const std::string& words, const std::string& unit = {}) {
    at_.y -= 0.7 * em_;
    painter_.text({at_.x, at_.y}, words,
                  {.height = em_, .colour = colours_.text, .weight = FontWeight::semibold, .y = AlignY::top});
    if (!unit.empty())
      painter_.text({at_.x + width_, at_.y}, unit,
                    {.height = 0.85 * em_, .colour = colours_.muted, .x = AlignX::right, .y = AlignY::top});
    at_.y -= 1.75 * em_;
  }

  /// Words at the left, `value` at the right end; the middle of the line is returned.
  double row(const std::string& words, const std::string& value = {}, double indent = room_for_sample) {
    const double middle = at_.y - 0.55 * em_;
    painter_.text({at_.x + indent * em_, middle}, words,
                  {.height = 0.92 * em_, .colour = colours_.text, .y = AlignY::centre});
    painter_.text({at_.x + width_, middle}, value,
                  {.height = 0.92 * em_, .colour = colours_.text, .x = AlignX::right, .y = AlignY::centre});
    at_.y -= legend_row * em_;
    return middle;
  }

  void note(const std::string& words) {
    for (const std::string& line : wrapped(words, width_, 0.85 * em_, FontWeight::regular)) {
      painter_.text(at_, line, {.height = 0.85 * em_, .colour = colours_.muted, .y = AlignY::top});
      at_.y -= 1.3 * em_;
    }
  }

  void paint_sample(const SlopeKeyRow& entry, double middle) {
    using Sample = SlopeKeyRow::Sample;
    const PixelPoint from{at_.x, middle}, to{at_.x + 1.4 * em_, middle};
    switch (entry.sample) {
      case Sample::line:
        return painter_.line(from, to, hairline * em_ * entry.width, entry.colour);
      case Sample::dashes:
        return painter_.dashed(from, to, hairline * em_ * entry.width, 0.28 * em_, entry.colour);
      case Sample::area:
        return painter_.fill(PixelRect{from.x, middle - 0.45 * em_, to.x, middle + 0.45 * em_}, entry.colour, 0.3);
      case Sample::dot:
        return painter_.disc({at_.x + 0.7 * em_, middle}, 0.1 * em_, entry.colour);
      case Sample::cross:
        break;
    }
    NetPainter(painter_, {0, 0}, 1, em_)
        .paint_symbol({at_.x + 0.7 * em_, middle}, NetSymbol::cross, entry.colour, colours_.surface, 0.3 * em_);
  }

  void paint_sets() {
    const std::vector<SetStatistics> sets = statistics_by_set(net_.joints);
    heading(picture_word("Sets"), picture_word("mean dip/direction · κ"));
    const NetPainter symbols(painter_, {0, 0}, 1, em_);
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const PlaneAttitude mean = sets[i].mean_plane();
      const std::string kappa = sets[i].fisher.kappa ? format_number(*sets[i].fisher.kappa, 3) : "–";
      const double middle =
          row((sets[i].name.empty() ? picture_word("no set") : sets[i].name) + "  (" +
                  std::to_string(sets[i].members.size()) + ")",
              format_decimals(mean.dip, 1) + "° / " + format_decimals(mean.dip_direction, 1) + "° · " + kappa);
      symbols.paint_symbol({at_.x + 0.7 * em_, middle}, set_symbol(i), set_colour(i, net_.theme), colours_.surface,
                           0.38 * em_);
    }
  }

  void paint_density(const DrawnNet& drawn) {
    const PoleDensity density({}, *net_.density);
    heading(picture_word("Density") + ", " + std::string(to_string(*net_.density)), picture_word(density.unit()));
    const std::size_t count = drawn.levels.size();
    const std::vector<std::string> labels = tick_labels(drawn.levels);
    const double box = std::min(width_ / static_cast<double>(count), 3.2 * em_);
    for (std::size_t i = 0; i < count; ++i) {
      const double left = at_.x + box * static_cast<double>(i);
      painter_.fill(PixelRect{left, at_.y - 1.1 * em_, left + box, at_.y}, band_colour(i, count, net_.theme));
      painter_.text({left, at_.y - 1.35 * em_}, labels[i],
                    {.height = 0.8 * em_, .colour = colours_.text, .y = AlignY::top});
    }
    at_.y -= 2.7 * em_;
    const PlaneAttitude densest = attitude_of_normal(drawn.densest_at);
    note(picture_word("densest") + " " + format_number(drawn.densest, 3) + ": " + format_decimals(densest.dip, 0) +
         "° / " + format_decimals(densest.dip_direction, 0) + "°");
  }

  void paint_slope(const DrawnNet& drawn) {
    heading(picture_word("Slope"), picture_word(to_string(net_.mode)));
    for (const SlopeKeyRow& entry : slope_key(net_)) paint_sample(entry, row(entry.words, entry.value));
    if (judges_lines(net_.mode) && drawn.intersections > most_intersections)
      note(picture_word("too many intersections of single joints to be drawn"));
  }

  void count(const std::string& words, const KinematicCount& count) {
    row(words,
        std::to_string(count.count) + " / " + std::to_string(count.total) + "  ·  " +
            format_decimals(count.percent(), 1) + " %",
        0);
  }

  void paint_counts(const KinematicSetting& slope) {
    std::vector<PlaneAttitude> planes;
    for (const MeasuredJoint& joint : net_.joints) planes.push_back(joint.plane);
    const KinematicCounts counts = kinematic_counts(planes, slope);
    heading(picture_word("Critical"));
    count(picture_word("planar sliding"), counts.planar);
    count(picture_word("planar, no limits"), counts.planar_unlimited);
    count(picture_word("wedge sliding"), counts.wedge);
    count(picture_word("flexural toppling"), counts.flexural);
    count(picture_word("direct toppling"), counts.direct);
    count("  " + picture_word("base planes"), counts.base);
  }

  Painter& painter_;
  const Stereonet& net_;
  const ThemeColours& colours_;
  PixelPoint at_;  ///< upper left of what comes next
  double width_, em_;
};

}  // namespace

Painting stereonet_painting(const Stereonet& net, const std::string& title) {
  return [net, title, drawn = draw_net(net)](Painter& painter, double w, double h) {
    const ThemeColours& c = colours(net.theme);
    const double em = std::max(11.0, std::min(h / 44, w / 66)), edge = 1.2 * em;
    const double key_width = std::min(24 * em, 0.4 * w);
    const double title_height = (title.empty() ? 0 : 2.6) * em, foot = 1.2 * em;
    const double room = std::min(w - key_width - 4 * edge, h - 2 * edge - title_height - foot);
    const double radius = room / 2 / room_for_words;
    const PixelPoint centre{edge + (w - key_width - 4 * edge) / 2,
                            edge + foot + (h - 2 * edge - title_height - foot) / 2};
    const NetPainter net_painter(painter, centre, radius, em);
    for (const NetShape& shape : drawn.shapes) std::visit(net_painter, shape);
    painter.text({edge, h - edge}, title,
                 {.height = 1.25 * em, .colour = c.text, .weight = FontWeight::semibold, .y = AlignY::top});
    const bool is_one = net.joints.size() == 1;
    painter.text({edge, edge},
                 picture_word(net.projection == Projection::equal_area ? "equal area" : "equal angle") + ", " +
                     picture_word("lower hemisphere") + ", " + std::to_string(net.joints.size()) + " " +
                     picture_word(is_one ? "pole" : "poles"),
                 {.height = 0.85 * em, .colour = c.muted});
    Key(painter, net, {w - edge - key_width, h - edge - title_height + 0.7 * em}, key_width, em).paint(drawn);
  };
}

Image draw_stereonet(const Stereonet& net, const std::string& title, int width, int height) {
  return painted_image(width, height, colours(net.theme).surface, stereonet_painting(net, title));
}

}  // namespace talus
