#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "render/scene/offscreen.hpp"

namespace talus::cli {

namespace {

struct RenderOptions {
  std::filesystem::path results, out;
  FrameChoice choice;
  PictureSize size{1600, 1000};
  Look look;
};

ExitCode render(const RenderOptions& options, bool json) {
  const ResultReader results(options.results);
  const int index = about(options.results, [&] { return frame_index(results, options.choice); });
  Scene scene(results.system(), scene_settings(options.look, results));
  scene.set_stage_names(results.stage_names());
  scene.set_frame(std::make_shared<const Frame>(results.frame(index)));
  mark_troubles(options.look, results, scene);
  point_camera(options.look, results, scene);
  render_png(scene, options.out, options.size.width, options.size.height);

  const double time = results.frame_times()[static_cast<std::size_t>(index)];
  if (json) {
    const nlohmann::ordered_json picture = {{"picture", options.out.string()},
                                            {"width", options.size.width},
                                            {"height", options.size.height},
                                            {"frame", index},
                                            {"time", time}};
    std::cout << picture.dump(2) << '\n';
  } else {
    std::cout << options.out.string() << ": frame " << index << ", " << time << " s\n";
  }
  return done;
}

}  // namespace

void add_render(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand("render", "Draw one frame as a PNG; needs no display");
  auto options = std::make_shared<RenderOptions>();
  add_results(*command, options->results);
  command->add_option("--out", options->out, "Picture to write")->required()->type_name("P.png");
  add_frame_choice(*command, options->choice);
  add_size(*command, options->size);
  add_look(*command, options->look);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return render(*options, invocation.json); };
  });
}

}  // namespace talus::cli
