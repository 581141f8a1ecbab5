#include "project_choice.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <iterator>

#include "base/memory_limit.hpp"
#include "command.hpp"
#include "geometry/block_builder.hpp"
#include "io/whole_file.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

void add_project(CLI::App& command, ProjectChoice& choice, const std::string& name, const std::string& help) {
  command.add_option(name, choice.file, help)->required()->type_name("PATH");
  command.add_flag("--allow-outside", choice.reading.allow_outside,
                   "Let the project name files outside its own folder");
  command
      .add_option_function<std::string>(
          "--max-memory",
          [](const std::string& size) {
            const auto bytes = bytes_from(size);
            if (!bytes) throw CLI::ValidationError("--max-memory", size + " is no size; give it as 16GB");
            set_memory_limit(*bytes);
          },
          "What cutting, meshing and solving may hold, as 16GB; what is foreseen to take more is refused (default: "
          "what "
          "the machine has free)")
      ->type_name("SIZE");
}

std::string text_of(const ProjectChoice& choice) {
  if (choice.is_standard_input()) return {std::istreambuf_iterator<char>(std::cin), {}};
  return about(choice.name(), [&] { return read_whole_file(choice.file); });
}

Project read(const ProjectChoice& choice, const std::string& text) {
  return about(choice.name(), [&] { return parse_project_in(choice.folder(), text, choice.reading); });
}

Project read(const ProjectChoice& choice) { return read(choice, text_of(choice)); }

BlockSystem build(const Project& project, const ProjectChoice& choice) {
  return about(choice.name(), [&] {
    TerminalProgress progress;
    return build_blocks(project, choice.folder(), progress);
  });
}

}  // namespace talus::cli
