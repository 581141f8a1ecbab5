#include "geometry/mesher/brep_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "base/error.hpp"
#include "base/one_line.hpp"

namespace talus {
namespace {

/// All of a word, or nothing; too small a number is one.
template <class Number>
std::optional<Number> number_in(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool too_small = std::is_floating_point_v<Number> && error == std::errc::result_out_of_range &&
                         word.find("e-") != std::string_view::npos;
  if ((error != std::errc() && !too_small) || end != word.data() + word.size()) return std::nullopt;
  return number;
}

/// The words of a text file, and in which line they stand.
class Words {
 public:
  Words(std::string text, std::string file) : text_(std::move(text)), file_(std::move(file)) {}

  std::string_view next() {
    skip_space();
    constexpr std::size_t longest = 200;  // OpenCASCADE has room for 255
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    const std::string_view word(text_.data() + begin, at_ - begin);
    if (word.empty()) fail("it ends too early");
    if (word.size() > longest) fail("a word is too long");
    return word;
  }

  /// What is left of this line.
  std::string_view rest_of_line() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    const std::string_view rest(text_.data() + begin, at_ - begin);
    if (at_ < text_.size()) ++at_, ++line_;
    return rest;
  }

  bool ended() const { return at_ >= text_.size(); }

  int whole(int least = std::numeric_limits<int>::min(), int most = std::numeric_limits<int>::max()) {
    return whole_in(next(), least, most);
  }

  /// A number that letters may follow at once ("3CN"): they are the next word.
  int whole_before_letters(int least, int most) {
    std::string_view word = next();
    if (const std::size_t letter = word.find_first_of("CG"); letter != std::string_view::npos) {
      at_ -= word.size() - letter;
      word = word.substr(0, letter);
    }
    return whole_in(word, least, most);
  }

  bool flag() { return whole(0, 1) == 1; }

  double number() {
    const std::string_view word = next();
    const auto number = number_in<double>(word);
    if (!number || !std::isfinite(*number)) expected("a number", word);
    return *number;
  }

  void numbers(int count) {
    for (int i = 0; i < count; ++i) number();
  }

  void expect(std::string_view wanted) {
    const std::string_view word = next();
    if (word != wanted) expected("'" + std::string(wanted) + "'", word);
  }

  [[noreturn]] void expected(const std::string& what, std::string_view found) const {
    fail(what + " is expected, not '" + one_line(std::string(found.substr(0, 40))) + "'");
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + ": line " + std::to_string(line_), "is damaged: " + what,
                     "export the solid again as BREP");
  }

 private:
  int whole_in(std::string_view word, int least, int most) const {
    const auto number = number_in<int>(word);
    if (!number) expected("a whole number", word);
    if (*number < least || *number > most)
      expected("a number from " + std::to_string(least) + " to " + std::to_string(most), word);
    return *number;
  }

  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  void skip_space() {
    for (; at_ < text_.size() && is_space(text_[at_]); ++at_) line_ += text_[at_] == '\n';
  }

  std::string text_, file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// The tables of a file, in its order; each knows how many entries those before it have.
class BrepText {
 public:
  BrepText(Words& words, int version) : words_(words), version_(version) {}

  void check() {
    locations_ = table("Locations", [this](int known) { location(known); });
    curves_2d_ = table("Curve2ds", [this](int) { curve(2); });
    curves_ = table("Curves", [this](int) { curve(3); });
    polygons_ = table("Polygon3D", [this](int) { polygon(); });
    polygons_on_triangles_ = table("PolygonOnTriangulations", [this](int) { polygon_on_triangles(); });
    surfaces_ = table("Surfaces", [this](int) { surface(); });
    triangulations_ = table("Triangulations", [this](int) { triangulation(); });
    shapes_ = table("TShapes", [this](int known) { shape(known); });
    if (!part(shapes_)) words_.fail("it holds no shape");
  }

 private:
  template <class Entry>
  int table(std::string_view name, const Entry& entry) {
    words_.expect(name);
    const int count = words_.whole(0);
    if (name == "TShapes") shapes_ = count;
    for (int i = 0; i < count; ++i) entry(i);
    return count;
  }

  /// 0 stands for none, as OpenCASCADE has it everywhere.
  void one_of(int count) { words_.whole(0, count); }

  void location(int known) {
    constexpr int matrix = 12, highest_power = 1000;
    if (words_.whole(1, 2) == 1) return words_.numbers(matrix);
    while (words_.whole(0, known) != 0) words_.whole(-highest_power, highest_power);
  }

  int degree() {
    constexpr int highest = 25;  // of OpenCASCADE's B-splines and Bézier curves
    return words_.whole(1, highest);
  }

  /// At least two, so that there is something between them.
  int count_of_points() { return words_.whole(2); }

  void knots(int count) {
    for (int i = 0; i < count; ++i) {
      words_.number();
      words_.whole(1);
    }
  }

  /// In the plane of a surface's parameters, or in space.
  void curve(int dimensions) {
    enum { line = 1, circle, ellipse, parabola, hyperbola, bezier, spline, trimmed, offset };
    const int frame = dimensions == 2 ? 6 : 12;  // centre and axes
    switch (words_.whole(line, offset)) {
      case line:
        return words_.numbers(2 * dimensions);
      case circle:
      case parabola:
        return words_.numbers(frame + 1);
      case ellipse:
      case hyperbola:
        return words_.numbers(frame + 2);
      case bezier: {
        const bool weights = words_.flag();
        return points(degree() + 1, dimensions + weights);
      }
      case spline: {
        const bool weights = words_.flag();
        words_.flag();  // periodic
        degree();
        const int poles = count_of_points(), knots_count = count_of_points();
        points(poles, dimensions + weights);
        return knots(knots_count);
      }
      case trimmed:
        words_.numbers(2);
        return nested([&] { curve(dimensions); });
      default:
        words_.numbers(dimensions == 2 ? 1 : 4);
        return nested([&] { curve(dimensions); });
    }
  }

  void points(int count, int numbers_each) {
    for (int i = 0; i < count; ++i) words_.numbers(numbers_each);
  }

  /// Curves of curves and surfaces of surfaces.
  template <class Inner>
  void nested(const Inner& inner) {
    constexpr int deepest = 20;
    if (++depth_ > deepest) words_.fail("its curves are too deep in each other");
    inner();
    --depth_;
  }

  void surface() {
    enum { plane = 1, cylinder, cone, sphere, torus, extrusion, revolution, bezier, spline, trimmed, offset };
    constexpr int frame = 12;
    switch (words_.whole(plane, offset)) {
      case plane:
        return words_.numbers(frame);
      case cylinder:
      case sphere:
        return words_.numbers(frame + 1);
      case cone:
      case torus:
        return words_.numbers(frame + 2);
      case extrusion:
        words_.numbers(3);
        return nested([this] { curve(3); });
      case revolution:
        words_.numbers(6);
        return nested([this] { curve(3); });
      case bezier: {
        const bool u_weights = words_.flag(), v_weights = words_.flag();
        const int u_degree = degree(), v_degree = degree();
        return points((u_degree + 1) * (v_degree + 1), u_weights || v_weights ? 4 : 3);
      }
      case spline:
        return spline_surface();
      case trimmed:
        words_.numbers(4);
        return nested([this] { surface(); });
      default:
        words_.number();
        return nested([this] { surface(); });
    }
  }

  void spline_surface() {
    const bool u_weights = words_.flag(), v_weights = words_.flag();
    words_.flag();  // periodic along u
    words_.flag();  // and v
    degree();
    degree();
    const int u_poles = count_of_points(), v_poles = count_of_points();
    const int u_knots = count_of_points(), v_knots = count_of_points();
    for (int u = 0; u < u_poles; ++u) points(v_poles, u_weights || v_weights ? 4 : 3);
    knots(u_knots);
    knots(v_knots);
  }

  void polygon() {
    const int nodes = count_of_points();
    const bool parameters = words_.flag();
    words_.number();  // deflection
    points(nodes, parameters ? 4 : 3);
  }

  void polygon_on_triangles() {
    const int nodes = count_of_points();
    for (int i = 0; i < nodes; ++i) words_.whole(1);
    words_.expect("p");
    words_.number();
    if (words_.flag()) words_.numbers(nodes);
  }

  void triangulation() {
    const int nodes = words_.whole(3), triangles = words_.whole(1);
    const bool parameters = words_.flag(), normals = version_ == 3 && words_.flag();
    words_.number();
    points(nodes, parameters ? 5 : 3);
    for (int i = 0; i < triangles; ++i)
      for (int corner = 0; corner < 3; ++corner) words_.whole(1, nodes);
    if (normals) points(nodes, 3);
  }

  void shape(int known) {
    constexpr std::array<std::string_view, 8> kinds = {"Ve", "Ed", "Wi", "Fa", "Sh", "So", "CS", "Co"};
    const std::string_view kind = words_.next();
    if (kind == kinds[0])
      vertex();
    else if (kind == kinds[1])
      edge();
    else if (kind == kinds[3])
      face();
    else if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
      words_.expected("a kind of shape", kind);
    const std::string_view flags = words_.next();
    constexpr std::size_t count_of_flags = 7;
    if (flags.size() < count_of_flags || flags.find_first_not_of("01") != std::string_view::npos)
      words_.expected("seven flags", flags);
    while (part(known)) continue;
  }

  /// A shape that an earlier one is part of, with its sense and place. False at the end of the list.
  bool part(int known) {
    const std::string_view word = words_.next();
    if (word == "*") return false;
    constexpr std::string_view senses = "+-ie";
    const auto number = number_in<int>(word.substr(1));
    // They are counted from the last one.
    const bool is_there = number && *number > shapes_ - known && *number <= shapes_;
    if (senses.find(word[0]) == std::string_view::npos || !is_there)
      words_.expected("a shape that is in the file before", word);
    one_of(locations_);
    return true;
  }

  void vertex() {
    words_.numbers(4);
    for (;;) {
      words_.number();
      const int kind = words_.whole(0, 3);
      if (kind == 0) return;
      if (kind == 1) one_of(curves_);
      if (kind == 2) one_of(curves_2d_);
      if (kind == 3) words_.number();
      if (kind != 1) one_of(surfaces_);
      one_of(locations_);
    }
  }

  void edge() {
    words_.number();
    words_.flag();  // same parameters
    const bool same_range = words_.flag();
    words_.flag();  // degenerated
    std::optional<Range> known;
    while (const int kind = words_.whole(0, 7)) {
      const std::optional<Range> range = edge_in(kind);
      if (!range || !same_range) continue;
      if (known && !known->is_nearly(*range)) words_.fail("an edge ends elsewhere on one of its curves");
      known = range;
    }
  }

  /// Of the parameter along a curve.
  struct Range {
    double first = 0, last = 0;
    bool is_nearly(const Range& other) const {
      constexpr double allowed = 1e-2;
      return std::abs(first - other.first) + std::abs(last - other.last) <= allowed * std::abs(last - first);
    }
  };
  Range range() {
    const double first = words_.number();
    return {first, words_.number()};
  }

  /// One of the ways in which an edge is described, and from where to where it runs on a curve.
  std::optional<Range> edge_in(int kind) {
    enum {
      curve_in_space = 1,
      on_surface,
      on_closed_surface,
      between_surfaces,
      as_polygon,
      on_triangles,
      twice_on_them
    };
    if (kind == curve_in_space) {
      one_of(curves_);
      one_of(locations_);
      return range();
    }
    if (kind == on_surface || kind == on_closed_surface) {
      one_of(curves_2d_);
      if (kind == on_closed_surface) {
        words_.whole_before_letters(0, curves_2d_);
        continuity();
      }
      one_of(surfaces_);
      one_of(locations_);
      const Range on_curve = range();
      if (version_ == 2) words_.numbers(4);  // where on the surface that is
      return on_curve;
    }
    if (kind == between_surfaces) {
      continuity();
      for (int i = 0; i < 2; ++i) {
        one_of(surfaces_);
        one_of(locations_);
      }
    } else if (kind == as_polygon) {
      one_of(polygons_);
      one_of(locations_);
    } else {
      one_of(polygons_on_triangles_);
      if (kind == twice_on_them) one_of(polygons_on_triangles_);
      one_of(triangulations_);
      one_of(locations_);
    }
    return std::nullopt;
  }

  void continuity() {
    const std::string_view word = words_.next();
    if (word.size() != 2 || (word[0] != 'C' && word[0] != 'G')) words_.expected("a continuity", word);
  }

  /// OpenCASCADE takes the line after a face's own for one about triangles, whatever it holds.
  void face() {
    words_.flag();
    words_.number();
    one_of(surfaces_);
    one_of(locations_);
    words_.rest_of_line();
    const std::string_view triangles = words_.rest_of_line();
    constexpr std::string_view blank = " \t\r";
    if (triangles.find_first_not_of(blank) == std::string_view::npos) return;
    const std::size_t begin = triangles[0] == '2' ? triangles.find_first_not_of(blank, 1) : std::string_view::npos;
    if (begin == std::string_view::npos) words_.expected("an empty line", triangles);
    const std::string_view word = triangles.substr(begin, triangles.find_last_not_of(blank) + 1 - begin);
    const auto number = number_in<int>(word);
    if (!number || *number < 0 || *number > triangulations_) words_.expected("triangles of the file", triangles);
  }

  Words& words_;
  int version_, depth_ = 0;
  int locations_ = 0, curves_2d_ = 0, curves_ = 0, polygons_ = 0, polygons_on_triangles_ = 0, surfaces_ = 0;
  int triangulations_ = 0, shapes_ = 0;
};

}  // namespace

void check_brep_text(const MesherSolid& solid, std::string text) {
  constexpr std::string_view beginning = "CASCADE Topology V";
  Words words(std::move(text), solid.file_as_written);
  while (!words.ended()) {
    const std::string_view line = words.rest_of_line();
    if (!line.starts_with(beginning)) continue;
    const std::string_view version = line.substr(beginning.size());
    if (version.starts_with("1,") || version.starts_with("2,") || version.starts_with("3,"))
      BrepText(words, version[0] - '0').check();
    return;
  }
}

}  // namespace talus
