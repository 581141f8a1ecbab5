#include "report/report.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "output_file.hpp"
#include "text/json_text.hpp"

namespace talus::cli {

namespace {

ExitCode report_results(const std::filesystem::path& results, const std::filesystem::path& out, bool json) {
  const report::Writer write = report::writer_for(out);
  const report::Document document = about(results, [&] { return report::report_of(results); });
  write_output(out, write(document));
  if (json)
    std::cout << json_text({{"report", out.string()}}) << '\n';
  else
    std::cout << out.string() << '\n';
  return done;
}

}  // namespace

void add_report(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("report", "Write all that a reader needs to believe a run, as HTML or PDF");
  auto results = std::make_shared<std::filesystem::path>();
  auto out = std::make_shared<std::filesystem::path>();
  add_results(*command, *results);
  command->add_option("--out", *out, "File to write; its ending says the format")
      ->required()
      ->type_name("R.html|R.pdf");
  command->callback([&invocation, results, out] {
    invocation.run = [&invocation, results, out] { return report_results(*results, *out, invocation.json); };
  });
}

}  // namespace talus::cli
