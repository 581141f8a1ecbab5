#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "document/document.hpp"

namespace talus {

/// A project's text and what it means, in two ways.
struct Document::Content {
  std::string text;
  Json json;
  Project project;
};

}  // namespace talus
