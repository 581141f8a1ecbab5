#include <dlfcn.h>

#include <stdexcept>

#include "base/installed.hpp"
#include "render/film/mp4_encoder.hpp"

namespace talus {

namespace {

/// From the module that was installed or built with this program. It stays: its libraries cannot all be unloaded.
decltype(&talus_new_mp4_encoder) loaded_encoder() {
  const auto module = installed_or("libexec/talus/talus-mp4.so", TALUS_MP4_BUILT);
  void* const library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const encoder = library ? dlsym(library, "talus_new_mp4_encoder") : nullptr;
  if (!encoder) throw std::runtime_error(dlerror());
  return reinterpret_cast<decltype(&talus_new_mp4_encoder)>(encoder);
}

}  // namespace

std::unique_ptr<MovieEncoder> make_mp4_encoder(const std::filesystem::path& path, int width, int height, int fps) {
  static const auto new_encoder = loaded_encoder();
  return std::unique_ptr<MovieEncoder>(new_encoder(path, width, height, fps));
}

}  // namespace talus
