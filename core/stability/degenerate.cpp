#include "mesh/moments.hpp"
#include "stability/all_scenes.hpp"
#include "stability/balance.hpp"
#include "stability/degenerate_meetings.hpp"
#include "stability/expectations.hpp"
#include "stability/shapes.hpp"

namespace talus {

namespace {

/// What is done to the block that meets the fixed one.
enum class Treatment { left_alone, dropped, pushed };

constexpr double drop = 0.05;                  // m
constexpr double push = 0.2;                   // of the weight: far from what friction, tan 30°, gives way to
constexpr double friction_angle = 30;          // degrees
constexpr double far_away = 1e6;               // m
constexpr double step = 1e-3, duration = 2.0;  // s
constexpr double settled = 1e-6, slow = 1e-3;  // m, m/s
constexpr double sag = 1e-3;                   // m: a tip of hard rock gives by micrometres

PointLoad sideways_push(const CaseScene& scene, const Meeting& meeting) {
  const Block& block = scene.system.blocks.back();
  const VolumeMoments moments = volume_moments(block.mesh);
  const double weight = moments.volume * scene.project.materials[block.material].density * scene.project.gravity.norm();
  return {.block = block.name, .at = moments.centroid, .force = push * weight * meeting.side};
}

CaseScene meeting_scene(const Meeting& meeting, Treatment treatment, const Vec3& place) {
  CaseScene scene = rock_scene(friction_angle);
  scene.project.gravity = -scene.project.gravity.norm() * meeting.up;
  meeting.add_bodies(scene);
  Stage free = motion(step, duration);
  if (treatment == Treatment::pushed) free.loads = {sideways_push(scene, meeting)};
  if (treatment == Treatment::dropped) shift_block(scene, meeting.block, drop * meeting.up);
  // What balances on a point is let go as it stands; what stands firmly presses itself on first.
  if (meeting.firm && treatment != Treatment::dropped) scene.project.stages.push_back(settling(0.01, 10));
  scene.project.stages.push_back(std::move(free));
  shift_scene(scene, place);
  return scene;
}

/// Firm meetings hold a drop and a push. A balance on a point or an edge holds no push: friction bears no moment there,
/// and a push of 0.2 g tips a block of about 1 m over within 1.5 s; left alone or dropped it stands or falls, to one
/// side.
std::vector<Demand> demands_of(const Meeting& meeting, Treatment treatment, const Vec3& place) {
  const Vec3 down = -meeting.up;
  const bool is_dropped = treatment == Treatment::dropped;
  std::vector<Demand> demands{stays_before(meeting.floor + place, meeting.up)};
  if (meeting.firm && is_dropped) {
    demands.push_back(travels(meeting.block, down, drop, 0.01));
    demands.push_back(stops(meeting.block, slow));
  } else if (meeting.firm) {
    demands.push_back(rests(meeting.block, 0, settled));
  } else {
    demands.push_back(comes_down_aside(meeting.block, meeting.up, is_dropped ? drop + sag : sag));
    if (treatment == Treatment::pushed) demands.push_back(travels_at_least(meeting.block, down, 0.3));
  }
  return demands;
}

StabilityScene scene_of(const Meeting& meeting, Treatment treatment, const Vec3& place) {
  const std::string words[] = {"rests", "dropped", "pushed"};
  const std::string titles[] = {"at rest", "dropped by 5 cm", "pushed sideways"};
  const std::size_t which = static_cast<std::size_t>(treatment);
  const bool is_far = !place.isZero();
  return {.name = meeting.name + "_" + words[which] + (is_far ? "_far" : ""),
          .group = "degenerate contact",
          .title = meeting.title + ", " + titles[which] + (is_far ? ", 1e6 m from the origin" : ""),
          .expected = demands_of(meeting, treatment, place),
          .build = [=] { return meeting_scene(meeting, treatment, place); }};
}

}  // namespace

std::vector<StabilityScene> degenerate_scenes() {
  std::vector<StabilityScene> scenes;
  for (const Meeting& meeting : meetings())
    for (const Vec3& place : {Vec3(0, 0, 0), Vec3(far_away, far_away, far_away)})
      for (const Treatment treatment : {Treatment::left_alone, Treatment::dropped, Treatment::pushed})
        scenes.push_back(scene_of(meeting, treatment, place));
  return scenes;
}

}  // namespace talus
