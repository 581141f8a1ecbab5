#pragma once

#include <string>

/// Texts of view files (ui/render/views/view_file says what they mean).
namespace talus {

/// The JSON of a view file's text, without its comments, once it has been held to resources/schema/view.schema.json.
/// Throws InputError with the place in the text.
std::string checked_view_text(const std::string& text);

/// JSON as Talus lays its files out: a member a line, numbers in their shortest form that reads back the same.
std::string laid_out(const std::string& json);

}  // namespace talus
