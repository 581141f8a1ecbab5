#pragma once

#include "widgets/project/page_table.hpp"

namespace talus {

/// The joints of a project: a row a cut, with its plane, how many there are and how far apart, where it ends, how it
/// scatters, and the strength of its joint; joints that cut nothing have a row too.
PageRows jointRows(const Project& project);

}  // namespace talus
