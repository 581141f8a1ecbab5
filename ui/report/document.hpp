#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "render/paint/image.hpp"
#include "render/paint/painter.hpp"

/// What a report says, before it becomes HTML or PDF. All texts are UTF-8.
namespace talus::report {

/// Lines of text. A verdict is said large, with a mark before it.
struct Paragraph {
  enum class Kind { plain, note, good, bad };
  std::string text;
  Kind kind = Kind::plain;
};

/// Names at the left, what they are at the right.
struct Facts {
  std::vector<std::pair<std::string, std::string>> rows;
};

/// Units stand in the heads.
struct Table {
  std::string title;
  std::vector<std::string> heads;
  std::string alignment;  ///< a letter a column, l or r
  std::vector<std::vector<std::string>> rows;
};

struct Picture {
  Image image;
  std::string caption;
};

/// Painted at `width` × `height` pixels, and put to scale with the width of the text.
struct Chart {
  Painting painting;
  double width = 700, height = 300;
  std::string caption;
};

using Part = std::variant<Paragraph, Facts, Table, Picture, Chart>;

struct Section {
  std::string title;
  std::vector<Part> parts;
};

struct Document {
  std::string title;
  std::vector<std::string> below_title;  ///< lines: when, by which version
  std::vector<Section> sections;
};

/// What a chart is painted on, and how wide: that of the text, in its pixels.
inline constexpr Rgb paper = rgb(0xffffff);

}  // namespace talus::report
