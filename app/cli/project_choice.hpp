#pragma once

#include <CLI/App.hpp>

#include <filesystem>
#include <string>

#include "io/project_file.hpp"
#include "mesh/block.hpp"

namespace talus::cli {

/// The project of a command, and what it may name: a file, or `-`, standard input. Paths in a project are relative to
/// its folder; that of standard input is the working folder.
struct ProjectChoice {
  std::filesystem::path file;
  ReadOptions reading;

  bool is_standard_input() const { return file == "-"; }
  std::filesystem::path folder() const { return file.parent_path(); }
  /// What errors call it.
  std::string name() const { return is_standard_input() ? "standard input" : file.string(); }
};

void add_project(CLI::App& command, ProjectChoice& choice, const std::string& name = "PROJECT",
                 const std::string& help = "Project file (.talus); - reads standard input");

/// The text of the project. Standard input has it once. Throws InputError whose place begins with the project's name.
std::string text_of(const ProjectChoice& choice);

/// The project that the text describes. Throws InputError whose place begins with the project's name.
Project read(const ProjectChoice& choice, const std::string& text);
Project read(const ProjectChoice& choice);

/// Cuts and meshes, and shows how far it is. Throws InputError whose place begins with the project's name, Cancelled on
/// Ctrl-C.
BlockSystem build(const Project& project, const ProjectChoice& choice);

}  // namespace talus::cli
