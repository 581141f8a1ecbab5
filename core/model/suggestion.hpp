#pragma once

#include <string>
#include <vector>

namespace talus {

/// The candidate that `name` was most likely meant to be (fewest letters inserted, removed, changed or swapped,
/// case aside), or nothing when none is near: more than a third of the letters would have to change.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

/// For a remedy: "did you mean 'density'?" or, when nothing is near, "use one of J1, J2" (the first few of many).
/// Empty when there are no candidates.
std::string suggest_name(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace talus
