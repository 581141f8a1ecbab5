#include "render/fields/field_range.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "render/paint/numbers.hpp"

namespace talus {

namespace {

/// Where blocks touch with next to nothing of their faces the stress is any number: the largest hundredth is left out.
constexpr double stress_left_out = 0.01;

ValueRange range_of_walls(std::span<const double> values, const Field& field) {
  ValueRange range;
  if (field.measure != Field::Measure::normal && field.measure != Field::Measure::shear) {
    range.include(values);
    return range;
  }
  std::vector<double> told;
  std::ranges::copy_if(values, std::back_inserter(told), [](double value) { return std::isfinite(value); });
  if (told.empty()) return range;
  const auto left_out = static_cast<std::ptrdiff_t>(stress_left_out * static_cast<double>(told.size()));
  for (const auto end : {left_out, static_cast<std::ptrdiff_t>(told.size()) - 1 - left_out}) {
    std::nth_element(told.begin(), told.begin() + end, told.end());
    range.include(told[static_cast<std::size_t>(end)]);
  }
  return range;
}

}  // namespace

ValueRange field_range(const FieldValues& fields, const Frame& frame, const Field& field) {
  return field_range(fields.system(), std::span<const double>(fields.of(frame, field)), field);
}

ValueRange field_range(const BlockSystem& system, std::span<const double> values, const Field& field) {
  const FieldPlace place = field.place();
  ValueRange range;
  if (field.place() == FieldPlace::wall) return range_of_walls(values, field);
  std::size_t begin = 0;
  for (const Block& block : system.blocks) {
    const std::size_t count = place == FieldPlace::block  ? 1
                              : place == FieldPlace::node ? block.mesh.nodes.size()
                                                          : block.mesh.tetrahedra.size();
    if (block.body != BodyKind::fixed) range.include(values.subspan(begin, count));
    begin += count;
  }
  return range;
}

bool is_signed(const Field& field) {
  using enum Field::Measure;
  return field.measure == component || field.measure == mean || field.measure == max_principal ||
         field.measure == min_principal || field.measure == volumetric;
}

ValueRange legend_range(const Field& field, const ValueRange& values) {
  ValueRange range;
  const double largest = values.empty() ? 0 : std::max(std::abs(values.low), std::abs(values.high));
  range.high = largest > 0 ? round_up(largest) : 1;
  range.low = is_signed(field) ? -range.high : 0;
  if (field.measure == Field::Measure::normal && !values.empty()) {  // of bonds, tension reaches below zero
    range.high = values.high > 0 ? round_up(values.high) : 0;
    if (values.low < 0) range.low = -round_up(-values.low);
    if (range.low == range.high) range.high = 1;
  }
  return range;
}

}  // namespace talus
