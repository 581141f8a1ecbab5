#pragma once

#include <QString>
#include <string_view>

namespace talus {

/// Words of the core, which are UTF-8, as Qt has them.
inline QString text(std::string_view words) {
  return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

/// With its first letter large.
inline QString sentenceCase(QString words) {
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words;
}

}  // namespace talus
