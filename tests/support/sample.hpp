#pragma once

#include <string>

#include "io/project_file.hpp"

namespace talus {

/// One of the shipped samples, by the name of its folder.
inline Project sample(const std::string& name) {
  return read_project(std::string(TALUS_SOURCE_DIR) + "/samples/" + name + "/" + name + ".talus");
}

}  // namespace talus
