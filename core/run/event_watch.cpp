#include "run/event_watch.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "solve/simulation.hpp"

namespace talus {

namespace {

/// A joint is seen to be open when its blocks have parted by this fraction of the smaller one's size.
constexpr double visible_opening = 0.01;
/// A block that touches something again within this time has only bounced [s].
constexpr double lasting_flight = 0.25;
/// A block topples when it has turned by this much [degrees].
constexpr double toppling_angle = 10;

double size_of(const Block& block) { return std::cbrt(block.volume); }

}  // namespace

EventWatch::EventWatch(const BlockSystem& system)
    : system_(system),
      joints_of_(system.blocks.size()),
      flights_(system.blocks.size()),
      motions_(system.blocks.size()),
      toppled_(system.blocks.size(), false) {}

void EventWatch::mark_closed(const ContactSample& contact) {
  const auto [first, second] = std::minmax(contact.blocks[0], contact.blocks[1]);
  flights_[first].touches = flights_[second].touches = true;
  const bool first_has_fewer = joints_of_[first].size() < joints_of_[second].size();
  for (const int number : joints_of_[first_has_fewer ? first : second]) {
    Joint& joint = joints_[number];
    if (joint.blocks[0] != first || joint.blocks[1] != second || joint.joint != contact.joint) continue;
    joint.closed = true;
    return;
  }
  for (const int block : {first, second}) joints_of_[block].push_back(static_cast<int>(joints_.size()));
  joints_.push_back({{first, second}, contact.joint});
}

void EventWatch::look(const Simulation& simulation) {
  const BodySet& bodies = simulation.bodies();
  const double time = simulation.time();
  for (const auto* moved : {&bodies.moving, &bodies.driven})
    for (const int b : *moved) motions_[b] = block_motion(bodies, b);
  for (const ContactSample& contact : simulation.awake_contacts())
    if (contact.state != ContactState::open) mark_closed(contact);
  for (const auto* moved : {&bodies.moving, &bodies.driven})
    for (const int b : *moved)
      for (const int number : joints_of_[b]) look_at(joints_[number], time);
  for (const int b : bodies.moving) look_at_block(b, time);
  last_look_ = time;
}

/// May be called for both of its blocks.
void EventWatch::look_at(Joint& joint, double time) {
  const auto [first, second] = joint.blocks;
  const Vec3 apart = motions_[first].displacement - motions_[second].displacement;
  const double visible = visible_opening * std::min(size_of(system_.blocks[first]), size_of(system_.blocks[second]));
  if (joint.closed) joint.apart_at_opening = apart;
  joint.closed = false;
  if (joint.told || (apart - joint.apart_at_opening).norm() < visible) return;
  joint.told = true;
  const std::string name = system_.joint_names.empty() ? "contact" : system_.joint_names[joint.joint];
  events_.push_back({time, name + " opens (" + system_.blocks[first].name + " - " + system_.blocks[second].name + ")"});
}

void EventWatch::look_at_block(int b, double time) {
  Flight& flight = flights_[b];
  if (flight.looked_at < last_look_) flight.since = last_look_;  // it was held or slept until then
  flight.looked_at = time;
  if (flight.touches) flight.since = time;
  flight.touched |= flight.touches;
  flight.touches = false;
  if (flight.touched && !flight.told && time - flight.since > lasting_flight) {
    flight.told = true;
    events_.push_back({flight.since, system_.blocks[b].name + " falls free"});
  }
  if (toppled_[b] || degrees(motions_[b].rotation) < toppling_angle) return;
  toppled_[b] = true;
  events_.push_back({time, system_.blocks[b].name + " topples (turned by 10°)"});
}

std::vector<Event> EventWatch::events() const {
  std::vector<Event> sorted = events_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Event& a, const Event& b) { return a.time < b.time; });
  return sorted;
}

}  // namespace talus
