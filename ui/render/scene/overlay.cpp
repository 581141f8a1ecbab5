#include "render/scene/overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/paint/numbers.hpp"
#include "render/paint/picture_words.hpp"

namespace talus {
namespace {

constexpr double margin = 1.3;  ///< of the picture's edge; this and all below in text heights
constexpr double padding = 0.8;
constexpr double line_height = 1.35;
constexpr double bar_width = 1.1;
constexpr double tick_length = 0.35;
constexpr double triad_size = 6.4;
constexpr double bottom_row = 2.6;
constexpr double widest_title = 8.5;
constexpr double hair = 0.07;  ///< line width

/// Where a legend's parts go; made once for the free area and once for painting.
struct LegendLayout {
  std::vector<std::string> title;
  std::vector<double> ticks;
  std::vector<std::string> labels;
  double width = 0, bar_height = 0, height = 0;  ///< pixels
};

double title_row(const Overlay& overlay) { return overlay.title.empty() ? 0 : 2.2 * overlay.text_height; }

/// Above the picture's lower edge, of text heights: what the axes of the triad take.
constexpr double triad_top = bottom_row + margin + triad_size - 0.6;

LegendLayout layout(const Overlay& overlay, double em, double picture_height) {
  const Legend& legend = *overlay.legend;
  LegendLayout out;
  out.title = wrapped(legend.title, widest_title * em, em, FontWeight::semibold);
  if (out.title.empty() || text_width(out.title.back() + "  " + legend.unit, em) > widest_title * em)
    out.title.emplace_back();  // the unit gets a line of its own
  const double around = static_cast<double>(out.title.size()) * line_height * em + (2 * padding + 1.1) * em;
  out.bar_height = std::min(15 * em, 0.42 * picture_height);
  if (overlay.triad) {  // which it does not reach into, however small the picture is
    const double room = picture_height - margin * em - title_row(overlay) - around - triad_top * em;
    out.bar_height = std::min(out.bar_height, std::max(room, 4 * em));
  }
  const int most = std::clamp(static_cast<int>(out.bar_height / (2.2 * em)) + 1, 2, 7);
  out.ticks = nice_ticks(legend.low, legend.high, most);
  out.labels = tick_labels(out.ticks);
  double label_width = 0, title_width = 0;
  for (const std::string& label : out.labels) label_width = std::max(label_width, text_width(label, em));
  for (const std::string& line : out.title)
    title_width = std::max(title_width, text_width(line, em, FontWeight::semibold));
  title_width = std::max(title_width, text_width(out.title.back() + "  " + legend.unit, em, FontWeight::semibold));
  const double bar_part = (bar_width + 2 * tick_length) * em + label_width;
  out.width = std::max(bar_part, title_width) + 2 * padding * em;
  out.height = out.bar_height + around;
  return out;
}

/// A picture too low for both has the legend alone.
bool has_room_for_triad(const Overlay& overlay, double picture_height) {
  if (!overlay.legend) return true;
  const double em = overlay.text_height;
  return picture_height - margin * em - title_row(overlay) - layout(overlay, em, picture_height).height >=
         triad_top * em - 1;
}

double width_of(const ColourKey& key, double em) {
  double widest = text_width(key.title, em, FontWeight::semibold);
  for (const KeyEntry& entry : key.entries) widest = std::max(widest, 1.2 * em + text_width(entry.meaning, em));
  return widest + 2 * padding * em;
}

void paint_bar(Painter& painter, const ColourMap& map, const PixelRect& bar) {
  constexpr int bands = 256;
  const double step = bar.height() / bands;
  for (int i = 0; i < bands; ++i) {  // each band reaches under the next one: no seams between them
    const double bottom = bar.bottom + i * step;
    painter.fill(PixelRect{bar.left, bottom, bar.right, std::min(bottom + 2 * step, bar.top)},
                 map.table()[static_cast<std::size_t>(i)]);
  }
}

void paint_legend(Painter& painter, const Overlay& overlay, const OverlayView& view) {
  const Legend& legend = *overlay.legend;
  const double em = overlay.text_height;
  const ThemeColours& colour = colours(overlay.theme);
  const LegendLayout parts = layout(overlay, em, view.height);
  const double top = view.height - margin * em - title_row(overlay), left = margin * em;
  painter.card({left, top - parts.height, left + parts.width, top}, 0.4 * em, colour.surface, 0.92, colour.frame,
               hair * em);
  const double inner = left + padding * em;
  double y = top - padding * em;
  for (const std::string& line : parts.title) {
    painter.text({inner, y}, line,
                 {.height = em, .colour = colour.text, .weight = FontWeight::semibold, .y = AlignY::top});
    if (&line == &parts.title.back()) {
      const double gap = line.empty() ? 0
                                      : text_width(line + "n", em, FontWeight::semibold) -
                                            text_width("n", em, FontWeight::semibold) + 0.45 * em;
      painter.text({inner + gap, y}, legend.unit, {.height = em, .colour = colour.muted, .y = AlignY::top});
    }
    y -= line_height * em;
  }
  const double bar_top = y - 0.6 * em;
  const PixelRect bar{inner, bar_top - parts.bar_height, inner + bar_width * em, bar_top};
  paint_bar(painter, *legend.map, bar);
  for (std::size_t i = 0; i < parts.ticks.size(); ++i) {
    const double at = bar.bottom + bar.height() * (parts.ticks[i] - legend.low) / (legend.high - legend.low);
    painter.line({bar.right, at}, {bar.right + tick_length * em, at}, hair * em, colour.line);
    painter.text({bar.right + 2 * tick_length * em, at}, parts.labels[i],
                 {.height = em, .colour = colour.text, .y = AlignY::centre});
  }
}

void paint_colour_key(Painter& painter, const Overlay& overlay, const OverlayView& view) {
  const ColourKey& key = *overlay.colour_key;
  const double em = overlay.text_height, left = margin * em, inner = left + padding * em;
  const double top = view.height - margin * em - title_row(overlay);
  const double rows = static_cast<double>(key.entries.size() + 1);
  const ThemeColours& colour = colours(overlay.theme);
  painter.card({left, top - (2 * padding + rows * line_height) * em, left + width_of(key, em), top}, 0.4 * em,
               colour.surface, 0.92, colour.frame, hair * em);
  double y = top - padding * em;
  painter.text({inner, y}, key.title,
               {.height = em, .colour = colour.text, .weight = FontWeight::semibold, .y = AlignY::top});
  for (const KeyEntry& entry : key.entries) {
    y -= line_height * em;
    painter.disc({inner + 0.35 * em, y - 0.55 * em}, 0.35 * em, entry.colour);
    painter.text({inner + 1.2 * em, y}, entry.meaning, {.height = em, .colour = colour.text, .y = AlignY::top});
  }
}

/// East, north and up as seen from the camera, the nearest drawn last.
void paint_triad(Painter& painter, const Overlay& overlay, const OverlayView& view) {
  struct Axis {
    Vec3 direction;
    std::string name;
    Rgb colour;
  };
  const bool dark = overlay.theme == Theme::dark;
  std::array<Axis, 3> axes{Axis{Vec3::UnitX(), picture_word("E"), dark ? rgb(0xf27d6b) : rgb(0xb3261e)},
                           Axis{Vec3::UnitY(), "N", dark ? rgb(0x3fc7b3) : rgb(0x00806f)},
                           Axis{Vec3::UnitZ(), "Z", dark ? rgb(0x5db3ea) : rgb(0x0068a8)}};
  std::sort(axes.begin(), axes.end(), [&](const Axis& a, const Axis& b) {
    return a.direction.dot(view.towards_viewer) < b.direction.dot(view.towards_viewer);
  });
  const double em = overlay.text_height, length = 0.3 * triad_size * em;
  const PixelPoint origin{(margin + triad_size / 2) * em, (bottom_row + margin + triad_size / 2 - 0.6) * em};
  for (const Axis& axis : axes) {
    const double x = axis.direction.dot(view.right), y = axis.direction.dot(view.up), shown = std::hypot(x, y);
    const PixelPoint tip{origin.x + length * x, origin.y + length * y};
    if (shown > 0.15) {  // an axis that points at the viewer is a dot
      const double ux = x / shown, uy = y / shown, head = 0.5 * em, half = 0.19 * em;
      const PixelPoint neck{tip.x - head * ux, tip.y - head * uy};
      if (shown * length > head) painter.line(origin, neck, 0.13 * em, axis.colour);
      const PixelPoint arrow[] = {
          {neck.x + half * uy, neck.y - half * ux}, tip, {neck.x - half * uy, neck.y + half * ux}};
      painter.fill(arrow, axis.colour);
      painter.text({tip.x + 0.62 * em * ux, tip.y + 0.62 * em * uy}, axis.name,
                   {.height = 0.9 * em,
                    .colour = axis.colour,
                    .weight = FontWeight::semibold,
                    .x = AlignX::centre,
                    .y = AlignY::centre});
    } else {
      painter.disc(origin, 0.22 * em, axis.colour);
    }
  }
}

void paint_scale_bar(Painter& painter, const Overlay& overlay, const OverlayView& view) {
  const double em = overlay.text_height;
  const ThemeColours& colour = colours(overlay.theme);
  const double longest = std::min(0.2 * view.width, 11 * em);
  const double metres = round_down(longest * view.metres_per_pixel), length = metres / view.metres_per_pixel;
  const double left = (margin + 0.2) * em, y = margin * em, tick = 0.4 * em;
  for (const double x : {left, left + length / 2, left + length})
    painter.line({x, y - hair * em / 2}, {x, y + (x == left + length / 2 ? 0.6 : 1) * tick}, 1.3 * hair * em,
                 colour.text);
  painter.line({left, y}, {left + length, y}, 1.3 * hair * em, colour.text);
  const DisplayUnit unit = metres >= 1000 ? DisplayUnit{"km", 1e-3} : display_unit("m", metres);
  const std::string label = tick_labels({0, metres * unit.factor}).back() + " " + unit.name;
  TextStyle style{.height = 0.9 * em, .colour = colour.text, .x = AlignX::centre};
  painter.text({left, y + 1.3 * tick}, "0", style);
  painter.text({left + length, y + 1.3 * tick}, label, style);
}

/// Where what is written along the bottom begins: right of the scale bar's place.
double left_of_words(const Overlay& overlay, double width) {
  const double em = overlay.text_height;
  return (2 * margin + 1.5) * em + std::min(0.2 * width, 11 * em);
}

/// Pixels that the time takes at the right end, with the gap before it, whatever its figures: they change from frame to
/// frame, and its place should not.
double width_of_time(const Overlay& overlay) {
  std::string widest = overlay.time;
  for (char& c : widest)
    if (c >= '1' && c <= '9') c = '0';
  const double em = overlay.text_height;
  return widest.empty() ? 0 : text_width(widest, em, FontWeight::semibold) + em;
}

/// Lines of remarks above the time, right of the axes, where they do not fit beside it; none where they do.
std::vector<std::string> remarks_above(const Overlay& overlay, double width) {
  if (overlay.remarks.empty()) return {};
  const double em = overlay.text_height, right = width - margin * em;
  const double needed = text_width(overlay.remarks, em) + width_of_time(overlay);
  if (left_of_words(overlay, width) + needed <= right) return {};
  return wrapped(overlay.remarks, right - (margin + triad_size) * em, em, FontWeight::regular);
}

/// Right of the scale bar's place: "contacts ● open ● stick ● slip"; in several lines where there is no room in one,
/// and above the time where not even one entry fits beside it. Returns how many lines from the bottom it takes.
int paint_key(Painter& painter, const Overlay& overlay, const OverlayView& view) {
  const double em = overlay.text_height;
  const TextStyle words{.height = 0.9 * em, .colour = colours(overlay.theme).muted};
  const double left = left_of_words(overlay, view.width);
  double right = view.width - margin * em - width_of_time(overlay);
  if (!overlay.remarks.empty() && remarks_above(overlay, view.width).empty())
    right -= text_width(overlay.remarks, em) + em;
  const auto width_of = [&](const KeyEntry* entry, const std::string& meaning) {
    return (entry ? 0.85 * em : 0) + text_width(meaning, 0.9 * em);
  };
  int line = 0, lowest = 0;
  const auto fits = [&](const KeyEntry& entry) { return left + width_of(&entry, entry.meaning) <= right; };
  if (!std::ranges::all_of(overlay.key, fits)) {
    right = view.width - margin * em;
    lowest = 1;
  }
  struct Part {
    const KeyEntry* entry;  ///< null: the title
    double x;
    int line;
  };
  std::vector<Part> parts;
  double x = left;
  const auto place = [&](const KeyEntry* entry, const std::string& meaning) {
    const double width = width_of(entry, meaning);
    if (x > left && x + width > right) {
      x = left;
      ++line;
    }
    parts.push_back({entry, x, line});
    x += width + 0.8 * em;
  };
  if (!overlay.key_title.empty()) place(nullptr, overlay.key_title);
  for (const KeyEntry& entry : overlay.key) place(&entry, entry.meaning);
  for (const Part& part : parts) {
    const double y = margin * em - 0.2 * em + (lowest + line - part.line) * line_height * em;
    if (part.entry) painter.disc({part.x + 0.3 * em, y + 0.52 * em}, 0.28 * em, part.entry->colour);
    painter.text({part.x + (part.entry ? 0.85 * em : 0), y}, part.entry ? part.entry->meaning : overlay.key_title,
                 words);
  }
  return lowest + line + 1;
}

/// The time at the lower right; remarks left of it, or above it and `rows` of other words.
void paint_time(Painter& painter, const Overlay& overlay, const OverlayView& view, int rows) {
  const double em = overlay.text_height, y = margin * em - 0.2 * em, right = view.width - margin * em;
  const ThemeColours& colour = colours(overlay.theme);
  const double left = right - width_of_time(overlay);
  painter.text({left + (overlay.time.empty() ? 0 : em), y}, overlay.time,
               {.height = em, .colour = colour.text, .weight = FontWeight::semibold});
  const TextStyle muted{.height = em, .colour = colour.muted, .x = AlignX::right};
  const std::vector<std::string> above = remarks_above(overlay, view.width);
  if (above.empty()) painter.text({left, y}, overlay.remarks, muted);
  for (std::size_t i = 0; i < above.size(); ++i)
    painter.text({right, y + (rows + static_cast<double>(above.size() - 1 - i)) * line_height * em}, above[i], muted);
}

}  // namespace

double automatic_text_height(double width, double height) {
  return std::max(11.0, std::round(std::min(height / 48, width / 64)));
}

namespace {

/// How high rock, which mostly is wider than high, can be drawn there.
double room_for_rock(const PixelRect& area) {
  constexpr double rock = 1.5;  // its width over its height
  return std::min(area.width() / rock, area.height());
}

/// `beside` the legend; or, in an upright picture, below it, where rock is much larger there.
PixelRect beside_or_below_legend(const Overlay& overlay, const PixelRect& beside, double left, double height) {
  constexpr double much = 1.15;
  const double em = overlay.text_height;
  PixelRect below = beside;
  below.left = left;
  below.top -= layout(overlay, em, height).height + margin * em;
  return room_for_rock(below) > much * room_for_rock(beside) ? below : beside;
}

}  // namespace

PixelRect free_area(const Overlay& overlay, double width, double height) {
  const double em = overlay.text_height;
  double left = margin * em;
  if (overlay.triad) left = std::max(left, (margin + triad_size) * em);
  const double left_below = left;
  if (overlay.legend) left = std::max(left, 2 * margin * em + layout(overlay, em, height).width);
  if (overlay.colour_key) left = std::max(left, 2 * margin * em + width_of(*overlay.colour_key, em));
  const bool has_bottom =
      overlay.scale_bar || !overlay.key.empty() || !overlay.time.empty() || !overlay.remarks.empty();
  const double above = static_cast<double>(remarks_above(overlay, width).size()) * line_height;
  const double bottom = (margin + (has_bottom ? bottom_row : 0) + above) * em;
  PixelRect area{left, bottom, width - margin * em, height - margin * em - title_row(overlay)};
  if (overlay.legend) area = beside_or_below_legend(overlay, area, left_below, height);
  // A picture too small for its writing: the rock matters more.
  if (area.width() < 0.4 * width) area.left = area.right - 0.4 * width;
  if (area.height() < 0.4 * height) area.bottom = area.top - 0.4 * height;
  return area;
}

void paint(Painter& painter, const Overlay& overlay, const OverlayView& view) {
  const double em = overlay.text_height;
  if (!overlay.title.empty())
    painter.text(
        {margin * em, view.height - 0.9 * margin * em}, overlay.title,
        {.height = 1.25 * em, .colour = colours(overlay.theme).text, .weight = FontWeight::semibold, .y = AlignY::top});
  if (overlay.legend) paint_legend(painter, overlay, view);
  if (overlay.colour_key && !overlay.legend) paint_colour_key(painter, overlay, view);
  if (overlay.triad && has_room_for_triad(overlay, view.height)) paint_triad(painter, overlay, view);
  if (overlay.scale_bar) paint_scale_bar(painter, overlay, view);
  const int rows = overlay.key.empty() ? 1 : paint_key(painter, overlay, view);
  paint_time(painter, overlay, view, rows);
}

}  // namespace talus
