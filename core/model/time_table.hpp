#pragma once

#include "model/project.hpp"

namespace talus {

/// The table's value at a time [s]: linear between rows, constant before the first and after the last. The table is not
/// empty and its times ascend.
Vec3 value_at(const TimeTable& table, double time);

}  // namespace talus
