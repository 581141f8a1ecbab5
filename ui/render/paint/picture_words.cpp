#include "render/paint/picture_words.hpp"

#include <utility>

namespace talus {

namespace {

std::function<std::string(std::string_view)>& spoken() {
  static std::function<std::string(std::string_view)> translation;
  return translation;
}

}  // namespace

void translate_pictures(std::function<std::string(std::string_view)> translation) { spoken() = std::move(translation); }

std::string picture_word(std::string_view english) {
  return spoken() && !english.empty() ? spoken()(english) : std::string(english);
}

}  // namespace talus
