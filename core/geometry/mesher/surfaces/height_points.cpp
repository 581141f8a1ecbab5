#include "geometry/mesher/surfaces/height_points.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

#include "base/error.hpp"

namespace talus {
namespace {

std::vector<std::string_view> entries_of(std::string_view line) {
  constexpr std::string_view between = " \t,;\r\"";
  std::vector<std::string_view> entries;
  for (;;) {
    const std::size_t begin = line.find_first_not_of(between);
    if (begin == std::string_view::npos) return entries;
    const std::size_t end = std::min(line.find_first_of(between, begin), line.size());
    entries.push_back(line.substr(begin, end - begin));
    line.remove_prefix(end);
  }
}

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

using Columns = std::array<std::size_t, 3>;

/// Those that the heading names, or the first three.
Columns columns_of(const std::vector<std::string_view>& heading) {
  const std::array<std::vector<std::string_view>, 3> names{
      {{"x", "easting", "east", "e"}, {"y", "northing", "north", "n"}, {"z", "elevation", "height", "h"}}};
  Columns columns{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto named = std::find_if(heading.begin(), heading.end(), [&](std::string_view entry) {
      std::string small(entry);
      std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
      return std::find(names[axis].begin(), names[axis].end(), small) != names[axis].end();
    });
    if (named == heading.end()) return {0, 1, 2};
    columns[axis] = static_cast<std::size_t>(named - heading.begin());
  }
  return columns;
}

std::optional<Vec3> point_in(const std::vector<std::string_view>& entries, const Columns& columns) {
  Vec3 point;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (columns[axis] >= entries.size()) return std::nullopt;
    const auto number = number_in(entries[columns[axis]]);
    if (!number) return std::nullopt;
    point[static_cast<Eigen::Index>(axis)] = *number;
  }
  return point;
}

}  // namespace

HeightPoints read_points(const std::string& path, const std::string& as_written, const Vec3& origin) {
  std::ifstream file(path);
  HeightPoints result;
  Columns columns{0, 1, 2};
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    const auto entries = entries_of(line);
    if (entries.empty() || entries.front().starts_with('#')) continue;
    if (const auto point = point_in(entries, columns)) {
      result.points.push_back(*point - origin);
    } else if (result.points.empty() && !number_in(entries.front())) {
      columns = columns_of(entries);
    } else {
      throw InputError(as_written + ":" + std::to_string(number), "is not a point: '" + line.substr(0, 40) + "'",
                       "give three numbers a line, x, y and z in metres");
    }
  }
  return result;
}

}  // namespace talus
