#pragma once

#include "io/json_text.hpp"

namespace talus {

/// Checks a project's text against resources/schema/project.schema.json. Throws InputError for the first fault, in
/// plain words: what the format knows but this version does not compute goes first, then unknown keys (with the
/// nearest known one), then the rest in the order of the text.
void check_against_schema(const JsonText& json);

}  // namespace talus
