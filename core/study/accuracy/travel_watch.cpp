#include "study/accuracy/travel_watch.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "bodies/block_motion.hpp"
#include "mesh/moments.hpp"

namespace talus {

namespace {

constexpr double setting_off = 0.01;       // of a block's size
constexpr double still_moving = 1.0 / 20;  // of the time that counts, its last part

bool has_dynamic_stage(const Project& project) {
  return std::any_of(project.stages.begin(), project.stages.end(),
                     [](const Stage& stage) { return stage.kind == StageKind::dynamic; });
}

/// Across gravity, where there is any.
double horizontal(const Vec3& way, const Vec3& gravity) {
  return gravity.norm() > 0 ? way.cross(gravity.normalized()).norm() : way.norm();
}

}  // namespace

TravelWatch::TravelWatch(const Project& project, const BlockSystem& system)
    : project_(project), counts_(!has_dynamic_stage(project)) {
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    if (block.body == BodyKind::fixed) continue;
    Way& way = ways_.emplace_back();
    way.block = static_cast<int>(b);
    way.mass = project.materials[static_cast<std::size_t>(block.material)].density * block.volume;
    way.reach = setting_off * std::cbrt(block.volume);
    way.place = volume_moments(block.mesh).centroid;
  }
}

void TravelWatch::look(const StepReport& step, const BodySet& bodies) {
  const double step_begin = step.time - step.time_step;
  if (!counts_ && project_.stages[static_cast<std::size_t>(step.stage)].kind == StageKind::dynamic) {
    counts_ = true;
    begin_ = step_begin;
    for (Way& way : ways_) way.anchor = way.gone;
  }
  end_ = step.time;
  for (Way& way : ways_) {
    const Vec3 gone = block_motion(bodies, way.block).displacement;
    if (counts_) follow(way, gone, step_begin - begin_, step.time - begin_);
    way.gone = gone;
  }
}

/// `begin`, `end` [s]: of the step in which the block went on to `gone`.
void TravelWatch::follow(Way& way, const Vec3& gone, double begin, double end) {
  Vec3 from = way.gone;
  while ((gone - way.anchor).norm() > way.reach) {
    const double before = (from - way.anchor).norm(), after = (gone - way.anchor).norm();
    const double share = std::clamp((way.reach - before) / (after - before), 0.0, 1.0);
    begin += share * (end - begin);
    from += share * (gone - from);
    way.anchor = from;
    way.last = begin;
    if (!way.first) way.first = begin;
  }
}

/// m, root mean square distance of the mass from its centre, before the run or by now.
double TravelWatch::extent(bool by_now) const {
  double mass = 0, squares = 0;
  Vec3 centre = Vec3::Zero();
  const auto place = [&](const Way& way) -> Vec3 { return by_now ? way.place + way.gone : way.place; };
  for (const Way& way : ways_) {
    mass += way.mass;
    centre += way.mass * place(way);
  }
  centre /= mass;
  for (const Way& way : ways_) squares += way.mass * (place(way) - centre).squaredNorm();
  return std::sqrt(squares / mass);
}

StudyTravel TravelWatch::travel() const {
  StudyTravel travel;
  if (ways_.empty()) return travel;
  double mass = 0;
  for (const Way& way : ways_) {
    travel.run_out = std::max(travel.run_out, horizontal(way.gone, project_.gravity));
    mass += way.mass;
    travel.mean += way.mass * way.gone;
    if (!way.first) continue;
    travel.start = std::min(travel.start.value_or(*way.first), *way.first);
    travel.end = std::max(travel.end.value_or(0), *way.last);
  }
  travel.mean /= mass;
  travel.extent_growth = extent(true) - extent(false);
  if (travel.end && *travel.end > (1 - still_moving) * (end_ - begin_)) travel.end.reset();
  return travel;
}

}  // namespace talus
