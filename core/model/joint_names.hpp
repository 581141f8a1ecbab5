#pragma once

#include <string>

#include "model/project.hpp"

namespace talus {

/// Names of the joints of a project that `has` holds of, as a list in a sentence; empty: there are none.
inline std::string joints_where(const Project& project, bool (*has)(const Joint&)) {
  std::string names;
  for (const Joint& joint : project.joints)
    if (has(joint)) names += (names.empty() ? "" : ", ") + joint.name;
  return names;
}

}  // namespace talus
