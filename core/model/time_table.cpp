#include "model/time_table.hpp"

#include <algorithm>

namespace talus {

Vec3 value_at(const TimeTable& table, double time) {
  const auto after =
      std::upper_bound(table.begin(), table.end(), time, [](double t, const TableRow& row) { return t < row.time; });
  if (after == table.begin()) return table.front().value;
  if (after == table.end()) return table.back().value;
  const TableRow& before = *(after - 1);
  const double share = (time - before.time) / (after->time - before.time);
  return before.value + share * (after->value - before.value);
}

}  // namespace talus
