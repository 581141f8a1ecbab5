#include "stability/shortfalls.hpp"

#include <algorithm>
#include <vector>

namespace talus {

namespace {

struct Cause {
  const char* words;
  std::vector<const char*> scenes;
};

/// Short, since every row of the table says it; docs/stability.md has the whole.
const std::vector<Cause>& causes() {
  static const std::vector<Cause> list{
      {"a jack still rolls at the end", {"interlocked_16"}},
  };
  return list;
}

}  // namespace

std::string known_shortfall(const std::string& name) {
  const std::string scene = name.substr(0, name.find('+'));
  for (const Cause& cause : causes())
    if (std::find(cause.scenes.begin(), cause.scenes.end(), scene) != cause.scenes.end()) return cause.words;
  return "";
}

}  // namespace talus
