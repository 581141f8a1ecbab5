#pragma once

#include <filesystem>
#include <string>

#include "model/project.hpp"

namespace talus {

struct ReadOptions {
  /// Lets `file` name things outside the project's folder ("../", absolute paths, links that lead out).
  bool allow_outside = false;
  /// The project is still being set up: it may lack solids, stages and the default joint.
  bool unfinished = false;
};

/// Parses the text of a `.talus` file (JSON, comments allowed), checks it against the schema and the rules of
/// model/validate, and throws InputError with a JSON pointer or a line as its place ("line 12, /materials/rock/young").
Project parse_project(const std::string& text, const ReadOptions& options = {});

/// The same of a text from `folder`, which no link that the project names may lead out of (unless that is allowed).
Project parse_project_in(const std::filesystem::path& folder, const std::string& text, const ReadOptions& options = {});

/// Reads a file; an InputError's place begins with what is wrong with the file itself when it cannot be read.
Project read_project(const std::filesystem::path& file, const ReadOptions& options = {});

/// The text of a project: `parse_project(write_project(p))` equals p, digit for digit.
/// Throws InputError when a number is not finite.
std::string write_project(const Project& project);

/// The same as a change of `previous_text`: comments, layout, spelling of numbers and order of keys stay wherever the
/// project says the same; an unchanged project gives the same text byte for byte. A previous text that is no project
/// is replaced altogether.
std::string write_project(const Project& project, const std::string& previous_text);

/// The text changed so that it says what `value` says, a JSON text too. Comments, layout, spelling of numbers and order
/// of keys stay wherever both say the same, and come with things that are moved in a list. Checks nothing but that both
/// are JSON: throws InputError where one is not.
std::string change_project_text(const std::string& text, const std::string& value);

/// Writes by way of a temporary file beside it, so that a failure leaves the old one. A project that is there already
/// is changed as by `write_project(project, previous_text)`. Throws InputError when the file cannot be written.
void save_project(const Project& project, const std::filesystem::path& file);

}  // namespace talus
