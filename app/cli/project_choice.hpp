#pragma once

#include <CLI/App.hpp>

#include <filesystem>
#include <string>

#include "io/project_file.hpp"
#include "mesh/block.hpp"

namespace talus::cli {

/// The project file of a command, and what it may name.
struct ProjectChoice {
  std::filesystem::path file;
  ReadOptions reading;
};

void add_project(CLI::App& command, ProjectChoice& choice, const std::string& name = "PROJECT",
                 const std::string& help = "Project file (.talus)");

/// Throws InputError whose place begins with the file.
Project read(const ProjectChoice& choice);

/// Cuts and meshes, and shows how far it is. Throws InputError whose place begins with the file, Cancelled on Ctrl-C.
BlockSystem build(const Project& project, const ProjectChoice& choice);

}  // namespace talus::cli
