#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "csv.hpp"
#include "options.hpp"
#include "results/vtu.hpp"
#include "terminal.hpp"

namespace talus::cli {

namespace {

struct ExportOptions {
  std::filesystem::path results, out;
  std::string as;
  FrameChoice choice;
};

std::vector<int> chosen_frames(const ExportOptions& options, const ResultReader& results) {
  const int last = frame_index(results, options.choice);
  if (options.choice.time || options.choice.frame) return {last};
  std::vector<int> all;
  for (int i = 0; i <= last; ++i) all.push_back(i);
  return all;
}

std::string frame_name(int index) {
  char name[24];
  std::snprintf(name, sizeof name, "frame-%06d", index);
  return name;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw InputError(folder.string(), "cannot be made: " + failure.message(), "choose another folder");
}

void write_frames(const ExportOptions& options, const ResultReader& results, const std::vector<int>& frames) {
  TerminalProgress progress;
  std::vector<std::pair<double, std::string>> series;
  for (const int index : frames) {
    const Frame frame = results.frame(index);
    const auto stem = options.out / frame_name(index);
    if (options.as == "vtu") {
      series.emplace_back(frame.time, frame_name(index) + ".vtu");
      write_vtu(results.system(), frame, options.out / series.back().second);
    } else {
      write_csv(results.system(), frame, stem);
    }
    progress.report(static_cast<double>(&index - frames.data() + 1) / static_cast<double>(frames.size()),
                    "frame " + std::to_string(index));
  }
  if (!series.empty()) write_pvd(series, options.out / "frames.pvd");
}

ExitCode export_results(const ExportOptions& options, bool json) {
  const ResultReader results(options.results);
  const auto frames = about(options.results, [&] { return chosen_frames(options, results); });
  make_folder(options.out);
  write_frames(options, results, frames);
  if (json) {
    const nlohmann::ordered_json result = {
        {"folder", options.out.string()}, {"as", options.as}, {"frames", frames.size()}};
    std::cout << result.dump(2) << '\n';
  } else {
    std::cout << options.out.string() << ": " << frames.size() << " frames as " << options.as << '\n';
  }
  return done;
}

}  // namespace

void add_export(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("export", "Write frames as VTU (ParaView) or as CSV tables");
  auto options = std::make_shared<ExportOptions>();
  add_results(*command, options->results);
  command->add_option("--out", options->out, "Folder to write into")->required()->type_name("DIR");
  command->add_option("--as", options->as, "Format")
      ->required()
      ->check(CLI::IsMember({"vtu", "csv"}))
      ->type_name("vtu|csv");
  add_frame_choice(*command, options->choice, "all frames");
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return export_results(*options, invocation.json); };
  });
}

}  // namespace talus::cli
