#include "export/export.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "export/export_folder.hpp"
#include "options.hpp"
#include "output_file.hpp"
#include "render/scene/block_colours.hpp"
#include "text/json_text.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

struct ExportOptions {
  std::filesystem::path results, out;
  std::string as;
  FrameChoice choice;

  bool chooses_a_frame() const { return choice.time || choice.frame; }
};

/// What was written, and how many frames are in it.
struct Exported {
  std::filesystem::path out;
  std::size_t frames = 0;
};

/// "stl" and "gltf" are files by themselves, as which `--out` can be named.
const char* ending_of(const std::string& format) { return format == "stl" ? ".stl" : format == "gltf" ? ".glb" : ""; }

/// As `--as` says, or the ending of the file.
std::string format_of(const ExportOptions& options) {
  if (!options.as.empty()) return options.as;
  for (const char* format : {"stl", "gltf"})
    if (options.out.extension() == ending_of(format)) return format;
  throw InputError("--as", "the format is missing", "say vtu, csv, stl or gltf, or let --out end in .stl or .glb");
}

/// The file of a single one: `--out` itself, or one in that folder, which is made.
std::filesystem::path file_to_write(const ExportOptions& options, const std::string& name, const char* ending) {
  if (options.out.extension() == ending) return options.out;
  prepare_export_folder(options.out);
  return options.out / (name + ending);
}

Exported write_stl(const ExportOptions& options, const ResultReader& results) {
  const int frame = frame_index(results, options.choice);
  const auto file = file_to_write(options, numbered_name("frame", frame, ""), ending_of("stl"));
  write_output(file, stl_of(results.system(), results.frame(frame)));
  return {file, 1};
}

Exported write_gltf(const ExportOptions& options, const ResultReader& results, Progress& progress) {
  const std::vector<BlockColour> colours = fractions_of_colours(results.system());
  if (options.chooses_a_frame()) {
    const int frame = frame_index(results, options.choice);
    const auto file = file_to_write(options, numbered_name("frame", frame, ""), ending_of("gltf"));
    write_output(file, glb_of(results.system(), results.frame(frame), colours));
    return {file, 1};
  }
  const std::string bytes = animated_glb_of(results, colours, progress);
  const auto file = file_to_write(options, "blocks", ending_of("gltf"));
  write_output(file, bytes);
  return {file, results.frame_times().size()};
}

Exported write_tables(const ExportOptions& options, const ResultReader& results, Progress& progress, auto write) {
  const std::vector<int> frames =
      options.chooses_a_frame() ? std::vector{frame_index(results, options.choice)} : all_frames(results);
  write(results, frames, options.out, progress);
  return {options.out, frames.size()};
}

ExitCode export_results(const ExportOptions& options, bool json) {
  const std::string format = format_of(options);
  catch_interrupts();
  const ResultReader results(options.results);
  Exported exported;
  {
    TerminalProgress progress;
    exported = format == "vtu"   ? write_tables(options, results, progress, export_vtu)
               : format == "csv" ? write_tables(options, results, progress, export_csv)
               : format == "stl" ? write_stl(options, results)
                                 : write_gltf(options, results, progress);
  }
  if (json) {
    const char* what = *ending_of(format) == '\0' ? "folder" : "file";
    const nlohmann::ordered_json result = {{what, exported.out.string()}, {"as", format}, {"frames", exported.frames}};
    std::cout << json_text(result) << '\n';
  } else {
    std::cout << exported.out.string() << ": " << exported.frames << (exported.frames == 1 ? " frame" : " frames")
              << " as " << format << '\n';
  }
  return done;
}

}  // namespace

void add_export(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand(
      "export", "Write results for other programs: VTU (ParaView), CSV tables, STL, or glTF (web, Blender)");
  auto options = std::make_shared<ExportOptions>();
  add_results(*command, options->results);
  command
      ->add_option("--out", options->out,
                   "Folder to write into, empty or not there; of STL and glTF also the file, D.stl or D.glb")
      ->required()
      ->type_name("DIR");
  command->add_option("--as", options->as, "Format (default: as the ending of --out says)")
      ->check(CLI::IsMember({"vtu", "csv", "stl", "gltf"}).description(""))
      ->type_name("vtu|csv|stl|gltf");
  add_frame_choice(*command, options->choice, "all; of STL the last");
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return export_results(*options, invocation.json); };
  });
}

}  // namespace talus::cli
