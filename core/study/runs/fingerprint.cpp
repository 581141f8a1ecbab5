#include "study/runs/fingerprint.hpp"

#include <cstdint>
#include <cstdio>

#include "io/whole_file.hpp"
#include "model/solid_shape.hpp"

namespace talus {

namespace {

/// FNV-1a, 64 bits.
std::uint64_t hash(std::uint64_t state, const std::string& bytes) {
  for (const char c : bytes) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return state;
}

}  // namespace

std::string fingerprint_of(const std::string& text, const Project& project, const std::filesystem::path& folder) {
  std::uint64_t state = hash(0xcbf29ce484222325, text);
  for (const Solid& solid : project.solids)
    if (const std::string* file = file_of(solid.shape)) state = hash(state, read_whole_file(folder / *file));
  char digits[20];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(state));
  return digits;
}

}  // namespace talus
