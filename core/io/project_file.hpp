#pragma once

#include <filesystem>
#include <string>

#include "model/project.hpp"

namespace talus {

/// Parses the text of a `.talus` file (JSON, comments allowed), checks it against the schema and the rules of
/// model/validate, and throws InputError with a JSON pointer or a line as its place.
Project parse_project(const std::string& text);

/// Reads a file; an InputError's place begins with what is wrong with the file itself when it cannot be read.
Project read_project(const std::filesystem::path& file);

/// The text of a project: `parse_project(write_project(p))` equals p, digit for digit.
std::string write_project(const Project& project);

/// Writes by way of a temporary file beside it, so that a failure leaves the old one.
void save_project(const Project& project, const std::filesystem::path& file);

}  // namespace talus
