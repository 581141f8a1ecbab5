#include "version/version.hpp"

// Written while building, by cmake/BuiltFrom.cmake.
extern const char built_commit[];     // empty where the source is no clone
extern const char built_libraries[];  // "Eigen 3.4.0, …"

namespace talus {

std::string version_text(const std::string& program) {
  std::string text = program + " " TALUS_VERSION "\n";
  if (*built_commit) text += std::string("commit ") + built_commit + '\n';
  return text + "built with " + built_libraries;
}

}  // namespace talus
