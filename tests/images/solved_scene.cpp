#include "images/solved_scene.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"
#include "geometry/block_builder.hpp"
#include "gui/example_projects.hpp"
#include "io/project_file.hpp"
#include "run/run.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

struct LastFrame final : RunObserver {
  void on_step(const StepReport&, const HistoryRow&, double) override {}
  void on_frame(std::shared_ptr<const Frame> frame) override { last = std::move(frame); }
  bool go_on() override { return true; }
  std::shared_ptr<const Frame> last;
};

void shorten(Project& project, int steps_a_stage) {
  for (Stage& stage : project.stages) {
    const double all = stage.steps ? *stage.steps : stage.duration.value_or(0) / stage.time_step;
    stage.steps = std::min(static_cast<int>(std::lround(all)), steps_a_stage);
    stage.duration.reset();
  }
  project.expect.clear();  // of times that do not come any more
}

SolvedScene run_of(Project project, BlockSystem system) {
  const fs::path out = fs::temp_directory_path() / ("talus_pictures_" + std::to_string(::getpid()));
  LastFrame observer;
  run(project, system, {.out = out, .project_text = {}}, observer);
  fs::remove_all(out);
  return {std::move(project), std::move(system), std::move(observer.last)};
}

}  // namespace

SolvedScene solved(Project project, const fs::path& folder, int steps_a_stage) {
  shorten(project, steps_a_stage);
  NoProgress nobody;
  BlockSystem system = build_blocks(project, folder, nobody);
  return run_of(std::move(project), std::move(system));
}

const SolvedScene& sliding_slab() {
  static const SolvedScene scene = [] {
    Project project = parse_project(example::slope);
    shorten(project, 60);
    NoProgress nobody;
    BlockSystem system = build_blocks(project, {}, nobody);
    int number = 0;
    for (Block& block : system.blocks)
      if (block.body != BodyKind::fixed && block.name != "crest")  // it bears point loads and a monitor of stress
        block.body = std::array{BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra}[number++ % 3];
    return run_of(std::move(project), std::move(system));
  }();
  return scene;
}

}  // namespace talus
