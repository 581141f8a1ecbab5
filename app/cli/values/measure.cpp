#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "command.hpp"
#include "export/slide_tables.hpp"
#include "options.hpp"
#include "render/charts/painted_image.hpp"
#include "render/charts/slide_charts.hpp"
#include "text/json_text.hpp"
#include "text/slide_text.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

struct MeasureOptions {
  std::filesystem::path results, out;
  FrameChoice choice;
  SlideSettings settings;
  PictureSize size{1600, 1000};
  Theme theme = Theme::light;
};

void write_into(const MeasureOptions& options, const Slide& slide, const BlockSystem& system) {
  export_slide(slide, system, options.out);
  if (slide.run_out.rock.blocks.empty()) return;
  const Rgb paper = colours(options.theme).surface;
  write_png(painted_image(options.size.width, options.size.height, paper, deposit_map(slide, options.theme)),
            options.out / "deposit.png");
  write_png(draw_chart(front_plot(slide, options.theme), options.size.width, options.size.height),
            options.out / "front.png");
}

ExitCode measure(const MeasureOptions& options, bool json) {
  catch_interrupts();
  const ResultReader results(options.results);
  const Slide slide = about(options.results, [&] {
    TerminalProgress progress;
    return measure_slide(results, frame_index(results, options.choice), options.settings, progress);
  });
  if (!options.out.empty()) write_into(options, slide, results.system());
  if (json) {
    std::cout << json_text(slide_json(slide, results.system())) << '\n';
    return done;
  }
  std::cout << results.project_name() << ", " << slide_text(slide, results.system());
  if (!options.out.empty()) std::cout << "Tables and pictures in " << options.out.string() << '\n';
  return done;
}

}  // namespace

void add_measure(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand(
      "measure", "Say what a slide came to: run-out, travel angle, deposit, velocity of the front, volume that moved");
  auto options = std::make_shared<MeasureOptions>();
  add_results(*command, options->results);
  command
      ->add_option("--moved", options->settings.run_out.moved,
                   "A block that has gone further than this has moved, m (default: a hundredth of the diagonal of all "
                   "blocks at rest)")
      ->type_name("L");
  command
      ->add_option("--direction", options->settings.run_out.azimuth,
                   "Which way is forward, degrees clockwise from north (default: as the rock that moved went)")
      ->type_name("A");
  command
      ->add_option("--cell", options->settings.cell,
                   "Side of a cell of the depth map, m (default: a round length, some 200 of them across)")
      ->type_name("L");
  command
      ->add_option(
          "--out", options->out,
          "Folder for front.csv, blocks.csv, deposit.csv (its outline), depth.asc (a grid for GIS) and pictures of "
          "deposit and front")
      ->type_name("DIR");
  add_frame_choice(*command, options->choice);
  add_size(*command, options->size);
  add_theme(*command, options->theme);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return measure(*options, invocation.json); };
  });
}

}  // namespace talus::cli
