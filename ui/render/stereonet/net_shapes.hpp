#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "orientation/projection.hpp"
#include "render/paint/colour.hpp"

/// What a net is drawn with, on a net of radius 1 with north up; whoever draws it (a picture, a window) puts it to
/// scale. Later shapes lie over earlier ones.
namespace talus {

/// Filled convex polygon. Neighbours share their edges: smooth edges would leave seams.
struct NetFill {
  std::vector<Vec2> corners;
  Rgb colour;
  double opacity = 1;
};

struct NetLine {
  std::vector<Vec2> points;
  Rgb colour;
  double width = 1;  ///< of a hairline
};

/// A pole or a line: told apart by shape as well as by colour.
enum class NetSymbol { disc, square, triangle, diamond, inverted_triangle, cross };

struct NetMarker {
  Vec2 at;
  NetSymbol symbol = NetSymbol::disc;
  Rgb colour, rim;
  double size = 1;  ///< 1: of a pole
};

struct NetWord {
  Vec2 at;
  std::string text;
  Rgb colour;
  bool strong = false;
};

using NetShape = std::variant<NetFill, NetLine, NetMarker, NetWord>;

/// Corners of a symbol about its middle, of radius 1; a disc's are many, a cross has those of two bars.
std::vector<std::vector<Vec2>> symbol_outline(NetSymbol symbol);

}  // namespace talus
