#include "results/export.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

struct ExportOptions {
  std::filesystem::path results, out;
  std::string as;
};

ExitCode export_results(const ExportOptions& options, bool json) {
  catch_interrupts();
  const ResultReader results(options.results);
  {
    TerminalProgress progress;
    const auto write = options.as == "vtu" ? export_vtu : export_csv;
    write(results, options.out, progress);
  }
  const auto frames = results.frame_times().size();
  if (json) {
    const nlohmann::ordered_json result = {{"folder", options.out.string()}, {"as", options.as}, {"frames", frames}};
    std::cout << result.dump(2) << '\n';
  } else {
    std::cout << options.out.string() << ": " << frames << " frames as " << options.as << '\n';
  }
  return done;
}

}  // namespace

void add_export(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("export", "Write all frames as VTU (ParaView) or as CSV tables");
  auto options = std::make_shared<ExportOptions>();
  add_results(*command, options->results);
  command->add_option("--out", options->out, "Folder to write into; it must be empty or not be there")
      ->required()
      ->type_name("DIR");
  command->add_option("--as", options->as, "Format")
      ->required()
      ->check(CLI::IsMember({"vtu", "csv"}).description(""))
      ->type_name("vtu|csv");
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return export_results(*options, invocation.json); };
  });
}

}  // namespace talus::cli
