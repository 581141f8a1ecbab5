#include "project_choice.hpp"

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "geometry/block_builder.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

void add_project(CLI::App& command, ProjectChoice& choice, const std::string& name, const std::string& help) {
  command.add_option(name, choice.file, help)->required()->type_name("PATH");
  command.add_flag("--allow-outside", choice.reading.allow_outside,
                   "Let the project name files outside its own folder");
}

Project read(const ProjectChoice& choice) {
  return about(choice.file, [&] { return read_project(choice.file, choice.reading); });
}

BlockSystem build(const Project& project, const ProjectChoice& choice) {
  return about(choice.file, [&] {
    TerminalProgress progress;
    return build_blocks(project, choice.file.parent_path(), progress);
  });
}

}  // namespace talus::cli
