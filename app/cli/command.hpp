#pragma once

#include <CLI/App.hpp>

#include <filesystem>
#include <functional>
#include <utility>

#include "base/error.hpp"

namespace talus::cli {

/// What a command ends with, as scripts rely on it (docs/manual.md). Bad input is an InputError, our fault any other
/// exception.
enum ExitCode { done = 0, failed = 1, bad_input = 2, our_fault = 3 };

/// What the user asked for, filled while the command line is read.
struct Invocation {
  bool json = false, quiet = false;
  std::function<ExitCode()> run;
};

// One file a command. Each adds its command to the program and sets `invocation.run` when it is chosen.
void add_new(CLI::App& program, Invocation& invocation);
void add_inspect(CLI::App& program, Invocation& invocation);
void add_blocks(CLI::App& program, Invocation& invocation);
void add_mesh(CLI::App& program, Invocation& invocation);
void add_solve(CLI::App& program, Invocation& invocation);
void add_render(CLI::App& program, Invocation& invocation);
void add_baseline(CLI::App& program, Invocation& invocation);
void add_animate(CLI::App& program, Invocation& invocation);
void add_measure(CLI::App& program, Invocation& invocation);
void add_plot(CLI::App& program, Invocation& invocation);
void add_verify(CLI::App& program, Invocation& invocation);
void add_study(CLI::App& program, Invocation& invocation);
void add_info(CLI::App& program, Invocation& invocation);
void add_export(CLI::App& program, Invocation& invocation);
void add_report(CLI::App& program, Invocation& invocation);
void add_stereonet(CLI::App& program, Invocation& invocation);
void add_completion(CLI::App& program, Invocation& invocation);

/// Calls `work` and puts `file` in front of the place of an InputError that comes out of it.
template <typename Work>
auto about(const std::filesystem::path& file, Work work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.place(), error.problem(), error.remedy());
  }
}

}  // namespace talus::cli
