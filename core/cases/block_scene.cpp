#include "cases/block_scene.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"

namespace talus {

CaseScene rock_scene(double friction_angle) {
  CaseScene scene;
  scene.project.name = "blocks";
  Material rock;
  rock.name = "rock";
  rock.density = 2600;
  rock.young = 50e9;
  rock.poisson = 0.24;
  scene.add_material(rock);
  Joint joint;
  joint.name = "joint";
  joint.friction_angle = friction_angle;
  scene.add_joint(joint);
  return scene;
}

void tilt(CaseScene& scene, double dip) {
  const double g = scene.project.gravity.norm();
  scene.project.gravity = g * Vec3(std::sin(radians(dip)), 0, -std::cos(radians(dip)));
}

void add_fixed_box(CaseScene& scene, const std::string& name, const Vec3& min, const Vec3& max) {
  scene.add_block(name, box_mesh(min, max, 1, 1, 1), BodyKind::fixed);
}

void add_box(CaseScene& scene, const std::string& name, const Vec3& min, const Vec3& max) {
  scene.add_block(name, box_mesh(min, max, 1, 1, 1), BodyKind::tetrahedra);
}

Stage settling(double time_step, int steps) {
  Stage stage;
  stage.name = "settle";
  stage.kind = StageKind::static_;
  stage.time_step = time_step;
  stage.steps = steps;
  return stage;
}

Stage motion(double time_step, double duration) {
  Stage stage;
  stage.name = "move";
  stage.time_step = time_step;
  stage.duration = duration;
  return stage;
}

std::vector<Moment> record(const CaseScene& scene, const CaseOptions& options, Progress& progress,
                           const std::function<bool(const Moment&)>& go_on) {
  const double s = options.scale, root = std::sqrt(s);
  std::vector<Moment> moments;
  run_scene(as_asked(scene, options), progress, [&](const Simulation& simulation, const StepReport& report) {
    Moment moment{simulation.time() / root, report.stage, {}};
    for (std::size_t b = 0; b < scene.system.blocks.size(); ++b) {
      BlockMotion block = block_motion(simulation.bodies(), static_cast<int>(b));
      block.displacement /= s;
      block.velocity /= root;
      moment.blocks.push_back(block);
    }
    moments.push_back(std::move(moment));
    return !go_on || go_on(moments.back());
  });
  return moments;
}

double farthest(const Moment& from, const Moment& to) {
  double way = 0;
  for (std::size_t b = 0; b < from.blocks.size(); ++b)
    way = std::max(way, (to.blocks[b].displacement - from.blocks[b].displacement).norm());
  return way;
}

bool sets_off(const CaseScene& scene, double distance, const CaseOptions& options, Progress& progress) {
  Moment settled;
  bool off = false;
  record(scene, options, progress, [&](const Moment& moment) {
    if (moment.stage == 0)
      settled = moment;
    else
      off = farthest(settled, moment) > distance;
    return !off;
  });
  return off;
}

Bracket narrowed(Bracket bracket, int runs, const std::function<bool(double)>& falls_at) {
  for (int i = 0; i < runs; ++i) {
    const double middle = bracket.middle();
    (falls_at(middle) ? bracket.falls : bracket.stands) = middle;
  }
  return bracket;
}

KnownCase at_any_scale(KnownCase full_size) {
  full_size.run = [run = full_size.run](const CaseOptions& options, Progress& progress) {
    CaseOutcome outcome = run(options, progress);
    for (Finding& finding : outcome.findings) {
      const double factor = finding.unit == "m"                            ? options.scale
                            : finding.unit == "s" || finding.unit == "m/s" ? std::sqrt(options.scale)
                                                                           : 1;
      finding.expected *= factor;
      finding.computed *= factor;
      if (finding.absolute) finding.tolerance *= factor;
    }
    return outcome;
  };
  return full_size;
}

}  // namespace talus
