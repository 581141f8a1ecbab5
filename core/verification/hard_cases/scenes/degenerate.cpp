#include "mesh/moments.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/scenes/degenerate_contacts.hpp"
#include "verification/hard_cases/scenes/scene_groups.hpp"
#include "verification/hard_cases/shapes.hpp"

namespace talus {

namespace {

/// What is done to the block on the fixed one.
enum class Treatment { left_alone, dropped, pushed };

constexpr double drop = 0.05;                  // m
constexpr double push = 0.2;                   // of the weight: far from what friction, tan 30°, yields to
constexpr double contact_friction_angle = 30;  // degrees
constexpr double far_away = 1e6;               // m
constexpr double contact_step = 1e-3, contact_duration = 2.0;  // s
constexpr double contact_settled = 1e-6, contact_slow = 1e-3;  // m, m/s
constexpr double sag = 1e-3;                                   // m: a tip of hard rock gives by micrometres

PointLoad sideways_push(const CaseScene& scene, const DegenerateContact& contact) {
  const Block& block = scene.system.blocks.back();
  const VolumeMoments moments = volume_moments(block.mesh);
  const double weight = moments.volume * scene.project.materials[block.material].density * scene.project.gravity.norm();
  return {.block = block.name, .at = moments.centroid, .force = push * weight * contact.side};
}

CaseScene contact_scene(const DegenerateContact& contact, Treatment treatment, const Vec3& place) {
  CaseScene scene = rock_scene(contact_friction_angle);
  scene.project.gravity = -scene.project.gravity.norm() * contact.up;
  contact.add_bodies(scene);
  Stage free = dynamic_stage(contact_step, contact_duration);
  if (treatment == Treatment::pushed) free.loads = {sideways_push(scene, contact)};
  if (treatment == Treatment::dropped) shift_block(scene, contact.block, drop * contact.up);
  // In unstable equilibrium the block is let go as it stands; a stable one is first pressed on by its weight.
  if (contact.stable && treatment != Treatment::dropped) scene.project.stages.push_back(static_stage(0.01, 10));
  scene.project.stages.push_back(std::move(free));
  shift_scene(scene, place);
  return scene;
}

/// Stable contacts hold a drop and a push. On a point or an edge no push is held: friction bears no moment there,
/// and a push of 0.2 g tips a block of about 1 m over within 1.5 s; left alone or dropped it stands or falls, to one
/// side.
std::vector<HardCaseExpectation> expectations_of(const DegenerateContact& contact, Treatment treatment,
                                                 const Vec3& place) {
  const Vec3 down = -contact.up;
  const bool is_dropped = treatment == Treatment::dropped;
  std::vector<HardCaseExpectation> expectations{stays_before(contact.floor + place, contact.up)};
  if (contact.stable && is_dropped) {
    expectations.push_back(travels(contact.block, down, drop, 0.01));
    expectations.push_back(stops(contact.block, contact_slow));
  } else if (contact.stable) {
    expectations.push_back(rests(contact.block, 0, contact_settled));
  } else {
    expectations.push_back(comes_down_aside(contact.block, contact.up, is_dropped ? drop + sag : sag));
    if (treatment == Treatment::pushed) expectations.push_back(travels_at_least(contact.block, down, 0.3));
  }
  return expectations;
}

HardCase scene_of(const DegenerateContact& contact, Treatment treatment, const Vec3& place) {
  const std::string words[] = {"rests", "dropped", "pushed"};
  const std::string titles[] = {"at rest", "dropped by 5 cm", "pushed sideways"};
  const std::size_t which = static_cast<std::size_t>(treatment);
  const bool is_far = !place.isZero();
  return {.name = contact.name + "_" + words[which] + (is_far ? "_far" : ""),
          .group = "degenerate contact",
          .title = contact.title + ", " + titles[which] + (is_far ? ", 1e6 m from the origin" : ""),
          .expected = expectations_of(contact, treatment, place),
          .build = [=] { return contact_scene(contact, treatment, place); }};
}

}  // namespace

std::vector<HardCase> degenerate_scenes() {
  std::vector<HardCase> scenes;
  for (const DegenerateContact& contact : degenerate_contacts())
    for (const Vec3& place : {Vec3(0, 0, 0), Vec3(far_away, far_away, far_away)})
      for (const Treatment treatment : {Treatment::left_alone, Treatment::dropped, Treatment::pushed})
        scenes.push_back(scene_of(contact, treatment, place));
  return scenes;
}

}  // namespace talus
