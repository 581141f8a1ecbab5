#include "render/scene/field_range.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/block.hpp"
#include "render/paint/numbers.hpp"

namespace talus {

ValueRange field_range(const BlockSystem& system, const Frame& frame, const Field& field) {
  return field_range(system, std::span<const double>(values(frame, field)), field);
}

ValueRange field_range(const BlockSystem& system, std::span<const double> values, const Field& field) {
  const bool at_nodes = field.place() == FieldPlace::node;
  ValueRange range;
  std::size_t begin = 0;
  for (const Block& block : system.blocks) {
    const std::size_t count = at_nodes ? block.mesh.nodes.size() : block.mesh.tetrahedra.size();
    if (block.body != BodyKind::fixed) range.include(values.subspan(begin, count));
    begin += count;
  }
  return range;
}

bool is_signed(const Field& field) {
  using enum Field::Measure;
  return field.measure == component || field.measure == mean || field.measure == max_principal ||
         field.measure == min_principal;
}

ValueRange legend_range(const Field& field, const ValueRange& values) {
  ValueRange range;
  const double largest = values.empty() ? 0 : std::max(std::abs(values.low), std::abs(values.high));
  range.high = largest > 0 ? round_up(largest) : 1;
  range.low = is_signed(field) ? -range.high : 0;
  return range;
}

}  // namespace talus
