#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace talus {

/// The words of pictures in another language: what `picture_word` gives from now on. To be set before anything is drawn
/// on another thread. Pictures are English where nobody sets it, as in scripts.
void translate_pictures(std::function<std::string(std::string_view english)> translation);

/// Some words of legends, keys, axes and titles, in the language of pictures.
std::string picture_word(std::string_view english);

}  // namespace talus
