#pragma once

#include <string>
#include <vector>

namespace talus {

/// The pointer that names the same place of the project by numbers: things in lists may be called by their names,
/// "/solids/slope/mesh_size" for "/solids/0/mesh_size". The last step may be what the project leaves to its default.
/// Throws InputError where the project has no such place; its own place is empty.
std::string numbered_pointer(const std::string& project_text, const std::string& column);

/// The project's text with these values, as JSON, at these places (numbered pointers); an empty value changes nothing.
/// Comments and layout stay.
std::string with_values(const std::string& project_text, const std::vector<std::string>& pointers,
                        const std::vector<std::string>& values);

}  // namespace talus
