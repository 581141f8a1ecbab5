#include <cmath>
#include <limits>

#include "base/units.hpp"
#include "geometry/block_builder.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/scenes/jointed_bench.hpp"
#include "verification/random/families.hpp"
#include "verification/random/random_parts.hpp"

namespace talus {

HardCase random_slope(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const int planes = numbers.whole(3, 5), seed = numbers.whole(1, std::numeric_limits<int>::max());
  const bool slides = numbers.chance(0.5), settles = numbers.chance(0.3);
  const BodyKind body = draw.body();
  // What is meshed takes a hundred times as long.
  const JointedBench bench{.planes = body == BodyKind::tetrahedra ? 3 : planes,
                           .seed = static_cast<unsigned>(seed),
                           .body = body,
                           .end = slides ? BenchEnd::slides : BenchEnd::stands};
  const double step = numbers.logarithmic(2e-3, 2e-2);
  SolverSettings settings;
  draw_settings(numbers, settings);
  settings.sleep_tolerance = 0;
  HardCase drawn;
  drawn.title = "bench that " + std::string(slides ? "slides" : "stands") + ", " + std::to_string(bench.planes) +
                " planes a set, " + std::string(to_string(body)) + ", bedding " + significant(bench.dip()) +
                "°, friction " + significant(bench.friction_angle()) + "°" + (settles ? ", static first" : "") +
                ", steps of " + significant(step) + " s";
  const double dip = radians(bench.dip());
  drawn.expected = {stays_before(Vec3::Zero(), Vec3(-std::sin(dip), 0, std::cos(dip)))};
  drawn.build = [=] {
    CaseScene scene{.project = bench.project(), .system = {}};
    scene.project.solver = settings;
    scene.project.stages = {dynamic_stage(step, 20 * step)};
    if (settles) scene.project.stages.insert(scene.project.stages.begin(), static_stage(step, 20));
    NoProgress nobody;
    scene.system = build_blocks(scene.project, {}, nobody);
    return scene;
  };
  return drawn;
}

}  // namespace talus
