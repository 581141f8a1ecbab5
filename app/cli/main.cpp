#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <new>
#include <string>

#include "base/one_line.hpp"
#include "base/progress.hpp"
#include "command.hpp"
#include "text/terminal.hpp"
#include "version/version.hpp"

namespace {

using namespace talus;
using namespace talus::cli;

void complain(const std::string& message) { std::cerr << "talus-cli: " << one_line(message) << '\n'; }

void describe(CLI::App& program) {
  program.description(
      "Jointed rock slopes by three-dimensional discontinuous deformation analysis.\n"
      "Units are SI: m, s, kg, N, Pa. Exit codes: 0 done; 1 done, but it did not converge, was stopped "
      "or a check failed;\n2 bad usage or bad input; 3 a fault of the program.");
  program.set_version_flag("--version", version_text("talus-cli"),
                           "Print the version, what it was built from, and leave");
  program.set_help_flag("-h,--help", "Print this help and leave");
  program.require_subcommand(1);
}

int usage_error(const CLI::App& program, const CLI::ParseError& error, const std::string& first_word) {
  const auto chosen = program.get_subcommands();
  if (!chosen.empty())
    complain("usage: " + std::string(error.what()) + "; see talus-cli " + chosen.front()->get_name() + " --help");
  else if (first_word.empty())
    complain("usage: a command is missing; see talus-cli --help");
  else
    complain("usage: there is no command or option '" + first_word + "'; see talus-cli --help");
  return bad_input;
}

int perform(const Invocation& invocation) {
  try {
    return invocation.run();
  } catch (const InputError& error) {
    complain(error.what());
    return bad_input;
  } catch (const Cancelled&) {
    complain("stopped; nothing was written");
    return failed;
  } catch (const std::filesystem::filesystem_error& error) {
    complain(error.path1().string() + ": " + error.code().message() + "; check the name, the permissions and the disk");
    return bad_input;
  } catch (const std::bad_alloc&) {
    complain("the memory of this computer does not suffice; take a coarser mesh or fewer blocks");
    return bad_input;
  } catch (const std::exception& error) {
    complain(std::string(error.what()) + "; this is a fault of the program: please report it");
    return our_fault;
  }
}

/// What was printed must have arrived: a script would take half of it for all.
int with_output(int code) {
  std::cout.flush();
  if (std::cout) return code;
  complain("standard output cannot be written; is the disk full?");
  return code == done ? failed : code;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("", "talus-cli");
  Invocation invocation;
  describe(program);
  for (const auto add : {add_new, add_inspect, add_blocks, add_mesh, add_solve, add_render, add_baseline, add_animate,
                         add_plot, add_measure, add_verify, add_study, add_info, add_export, add_report, add_stereonet})
    add(program, invocation);
  for (CLI::App* command : program.get_subcommands({})) {
    command->add_flag("--json", invocation.json, "Print one JSON object instead of text; progress goes to stderr");
    command->add_flag("-q,--quiet", invocation.quiet, "Do not say on stderr how far the work is");
  }
  add_completion(program, invocation);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
    return usage_error(program, error, argc > 1 ? argv[1] : "");
  }
  if (invocation.quiet) be_quiet();
  return with_output(perform(invocation));
}
