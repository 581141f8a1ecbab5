#include "render/paint/place_marks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

namespace {

// In text heights.
constexpr double ring = 0.95, inner_end = 0.35, outer_end = 1.4;  ///< radius; the cross reaches from here to there
constexpr double stroke = 0.17, halo = 0.42;                      ///< line widths
constexpr double mark_padding = 0.4, card_height = 1.5, label_height = 0.9, gap = 0.15;

bool inside(const PixelPoint& at, const MarkedPicture& picture) {
  return at.x >= 0 && at.x <= picture.width && at.y >= 0 && at.y <= picture.height;
}

bool meet(const PixelRect& a, const PixelRect& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

std::vector<PixelPoint> circle(const PixelPoint& centre, double radius) {
  constexpr int sides = 48;
  std::vector<PixelPoint> points;
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return points;
}

void paint_glyph(Painter& painter, const PixelPoint& at, double em, double width, Rgb colour) {
  painter.line(circle(at, ring * em), width, colour);
  for (const auto& [x, y] : {std::pair(1.0, 0.0), std::pair(-1.0, 0.0), std::pair(0.0, 1.0), std::pair(0.0, -1.0)})
    painter.line({at.x + inner_end * em * x, at.y + inner_end * em * y},
                 {at.x + outer_end * em * x, at.y + outer_end * em * y}, width, colour);
}

/// To the right of the mark, or to the left where there is no room.
PixelRect beside(const PlaceMark& mark, const MarkedPicture& picture) {
  const double em = picture.text_height;
  const double width = text_width(mark.label, label_height * em, FontWeight::semibold) + 2 * mark_padding * em;
  const double away = (outer_end + gap) * em, bottom = mark.at.y - card_height * em / 2;
  const auto at = [&](double left) { return PixelRect{left, bottom, left + width, bottom + card_height * em}; };
  const PixelRect right = at(mark.at.x + away);
  const bool is_free =
      std::none_of(picture.covered.begin(), picture.covered.end(), [&](const PixelRect& o) { return meet(right, o); });
  return right.right <= picture.width && is_free ? right : at(std::max(0.0, mark.at.x - away - width));
}

PixelRect moved_up(PixelRect rect, double by) {
  rect.bottom += by;
  rect.top += by;
  return rect;
}

/// The height nearest to its mark's at which a label meets none of the others.
PixelRect clear_of(const PixelRect& wanted, std::span<const PixelRect> others, const MarkedPicture& picture) {
  const double step = wanted.height() + gap * picture.text_height;
  for (int k = 0; k <= 2 * static_cast<int>(others.size()) + 1; ++k)
    for (const int side : {-1, 1}) {
      const PixelRect tried = moved_up(wanted, side * k * step / 2);
      const bool free = std::none_of(others.begin(), others.end(), [&](const PixelRect& o) { return meet(tried, o); });
      if (free && tried.bottom >= 0 && tried.top <= picture.height) return tried;
    }
  return wanted;
}

}  // namespace

std::vector<PixelRect> label_places(std::span<const PlaceMark> marks, const MarkedPicture& picture) {
  std::vector<PixelRect> places, taken = picture.covered;
  for (const PlaceMark& mark : marks) {
    places.push_back(inside(mark.at, picture) ? clear_of(beside(mark, picture), taken, picture) : PixelRect{});
    taken.push_back(places.back());
  }
  return places;
}

namespace {

void paint_cards(Painter& painter, std::span<const PlaceMark> marks, std::span<const PixelRect> places, Rgb frame,
                 const MarkedPicture& picture) {
  const ThemeColours& colour = colours(picture.theme);
  const double em = picture.text_height;
  for (std::size_t i = marks.size(); i-- > 0;) {
    const PixelRect& place = places[i];
    if (place.width() == 0) continue;
    painter.card(place, 0.3 * em, colour.surface, 0.94, frame, 0.09 * em);
    painter.text(
        {place.left + mark_padding * em, (place.bottom + place.top) / 2}, marks[i].label,
        {.height = label_height * em, .colour = colour.text, .weight = FontWeight::semibold, .y = AlignY::centre});
  }
}

}  // namespace

void paint_labels(Painter& painter, std::span<const PlaceMark> marks, const MarkedPicture& picture) {
  paint_cards(painter, marks, label_places(marks, picture), colours(picture.theme).frame, picture);
}

void paint_marks(Painter& painter, std::span<const PlaceMark> marks, const MarkedPicture& picture) {
  const ThemeColours& colour = colours(picture.theme);
  const double em = picture.text_height;
  const std::vector<PixelRect> places = label_places(marks, picture);
  for (std::size_t i = marks.size(); i-- > 0;) {
    if (places[i].width() == 0) continue;
    paint_glyph(painter, marks[i].at, em, halo * em, colour.surface);
    paint_glyph(painter, marks[i].at, em, stroke * em, colour.warn);
  }
  paint_cards(painter, marks, places, colour.warn, picture);
}

}  // namespace talus
