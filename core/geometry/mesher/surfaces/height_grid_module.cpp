#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

#include "base/installed.hpp"
#include "geometry/mesher/surfaces/height_grid.hpp"

namespace talus {

namespace {

/// From the module beside this program. It stays: GDAL cannot be unloaded.
decltype(&talus_read_grid) loaded_reader() {
  const auto module = program_folder() / TALUS_HEIGHT_GRID;
  void* const library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const reader = library ? dlsym(library, "talus_read_grid") : nullptr;
  if (!reader) throw std::runtime_error(dlerror());
  return reinterpret_cast<decltype(&talus_read_grid)>(reader);
}

}  // namespace

HeightPoints read_grid(const std::string& path, const std::string& as_written, const Vec3& origin) {
  static const auto reader = loaded_reader();
  HeightPoints result;
  reader(path, as_written, origin, result);
  return result;
}

}  // namespace talus
