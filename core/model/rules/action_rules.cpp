#include "model/rules/action_rules.hpp"

#include <algorithm>
#include <cmath>

#include "model/number_text.hpp"
#include "model/require.hpp"

namespace talus {
namespace {

void check_times(const TimeTable& table, const Place& place) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    require_finite(table[i].time, place / i / 0);
    require(i == 0 || table[i - 1].time < table[i].time, place / i / 0,
            "the times of a table must ascend, and " + number_text(table[i].time) + " s follows " +
                number_text(table[i == 0 ? 0 : i - 1].time) + " s",
            "sort the rows by time, one row for each");
  }
}

}  // namespace

void check(const Constraint& constraint, const Place& place) {
  if (constraint.at) require_finite(*constraint.at, place / "at");
  const auto& displacement = constraint.displacement;
  const bool by_table = !constraint.table.empty();
  const Place values = place / (by_table ? "table" : "displacement");
  require(displacement != decltype(constraint.displacement){}, values,
          "every component is free: this constraint holds nothing",
          "give at least one component in m, or remove the constraint");
  check_times(constraint.table, values);
  for (std::size_t i = 0; i < 3; ++i) {
    if (!displacement[i]) continue;
    if (!by_table) require_finite(*displacement[i], values / i);
    require(!by_table || *displacement[i] == 0, place / "displacement" / i,
            "is given beside the table, which says how the point moves", "give one of displacement and table");
    for (std::size_t row = 0; row < constraint.table.size(); ++row) {
      require(std::isfinite(constraint.table[row].value[static_cast<Eigen::Index>(i)]), values / row / (i + 1),
              "is no number here, and one in another row", "give a number in m, or null in every row for free");
    }
  }
}

void check(const PointLoad& load, const Place& place) {
  require_finite(load.at, place / "at");
  require_finite(load.force, place / "force");
  require(load.table.empty() || load.force.isZero(0), place / "force",
          "is given beside the table, which says how the force goes", "give one of force and table");
  check_times(load.table, place / "table");
  for (std::size_t row = 0; row < load.table.size(); ++row) {
    for (std::size_t i = 0; i < 3; ++i) {
      require_finite(load.table[row].value[static_cast<Eigen::Index>(i)], place / "table" / row / (i + 1));
    }
  }
}

void check(const InitialVelocity& velocity, const Place& place) {
  require_finite(velocity.linear, place / "linear");
  require_finite(velocity.angular, place / "angular");
}

void check(const InSituStress& in_situ, const Place& place) {
  for (std::size_t i = 0; i < 6; ++i) {
    const auto component = static_cast<Eigen::Index>(i);
    require_finite(in_situ.stress[component], place / "stress" / i);
    require_finite(in_situ.gradient[component], place / "gradient" / i);
  }
  require_finite(in_situ.level, place / "level");
}

}  // namespace talus
