#pragma once

#include "io/json_text.hpp"

namespace talus {

/// Checks a project's text against resources/schema/project.schema.json. Throws InputError for the first fault, in
/// plain words: unknown keys (with the nearest known one) go first, then the rest in the order of the text. An
/// `unfinished` project may lack what the schema asks of the project itself: its solids and stages.
void check_against_schema(const JsonText& json, bool unfinished = false);

/// Checks the text of a view file against resources/schema/view.schema.json, likewise.
void check_view_against_schema(const JsonText& json);

}  // namespace talus
