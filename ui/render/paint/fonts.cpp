#include "render/paint/fonts.hpp"

#include <filesystem>
#include <initializer_list>
#include <stdexcept>

#include "base/installed.hpp"

namespace talus {
namespace {

std::string first_of(std::initializer_list<const char*> files) {
  for (const std::string file : files) {
    const auto path = installed_or("share/talus/fonts" + file.substr(file.rfind('/')), "/usr/share/fonts/" + file);
    if (std::filesystem::exists(path)) return path;
  }
  throw std::runtime_error("no font to letter pictures with: install fonts-inter or fonts-dejavu-core");
}

}  // namespace

const std::string& font_file(FontWeight weight) {
  static const std::string regular = first_of({"opentype/inter/Inter-Regular.otf", "truetype/dejavu/DejaVuSans.ttf"});
  static const std::string semibold =
      first_of({"opentype/inter/Inter-SemiBold.otf", "truetype/dejavu/DejaVuSans-Bold.ttf"});
  return weight == FontWeight::semibold ? semibold : regular;
}

}  // namespace talus
