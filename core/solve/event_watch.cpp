#include "solve/event_watch.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "solve/simulation.hpp"

namespace talus {

namespace {

/// A joint is seen to be open when its blocks have parted by this share of the smaller one's size.
constexpr double visible_opening = 0.01;
/// A block that touches something again within this time has only bounced [s].
constexpr double lasting_flight = 0.25;
/// A block topples when it has turned by this much [degrees].
constexpr double toppling_angle = 10;

double size_of(const Block& block) { return std::cbrt(block.volume); }

}  // namespace

EventWatch::EventWatch(const BlockSystem& system)
    : system_(system),
      flights_(system.blocks.size()),
      motions_(system.blocks.size()),
      toppled_(system.blocks.size(), false) {}

void EventWatch::mark_closed(const ContactSample& contact) {
  const auto [first, second] = std::minmax(contact.blocks[0], contact.blocks[1]);
  flights_[first].touches = flights_[second].touches = true;
  for (Joint& joint : joints_)
    if (joint.blocks[0] == first && joint.blocks[1] == second && joint.joint == contact.joint) {
      joint.closed = true;
      return;
    }
  joints_.push_back({{first, second}, contact.joint});
}

void EventWatch::look(const Simulation& simulation, const std::vector<ContactSample>& contacts) {
  for (std::size_t b = 0; b < motions_.size(); ++b)
    motions_[b] = block_motion(simulation.bodies(), static_cast<int>(b));
  for (const ContactSample& contact : contacts)
    if (contact.state != ContactState::open) mark_closed(contact);
  look_at_joints(simulation.time());
  look_at_blocks(simulation);
}

void EventWatch::look_at_joints(double time) {
  for (Joint& joint : joints_) {
    const auto [first, second] = joint.blocks;
    const Vec3 apart = motions_[first].displacement - motions_[second].displacement;
    const double visible = visible_opening * std::min(size_of(system_.blocks[first]), size_of(system_.blocks[second]));
    if (joint.closed) joint.apart_at_opening = apart;
    joint.closed = false;
    if (joint.told || (apart - joint.apart_at_opening).norm() < visible) continue;
    joint.told = true;
    const std::string name = system_.joint_names.empty() ? "contact" : system_.joint_names[joint.joint];
    events_.push_back(
        {time, name + " opens (" + system_.blocks[first].name + " - " + system_.blocks[second].name + ")"});
  }
}

void EventWatch::look_at_blocks(const Simulation& simulation) {
  const double time = simulation.time();
  for (std::size_t b = 0; b < flights_.size(); ++b) {
    if (simulation.bodies().bodies[b].fixed) continue;
    Flight& flight = flights_[b];
    if (flight.touches) flight.since = time;
    flight.touched |= flight.touches;
    flight.touches = false;
    if (flight.touched && !flight.told && time - flight.since > lasting_flight) {
      flight.told = true;
      events_.push_back({flight.since, system_.blocks[b].name + " falls free"});
    }
    if (toppled_[b] || degrees(motions_[b].rotation) < toppling_angle) continue;
    toppled_[b] = true;
    events_.push_back({time, system_.blocks[b].name + " topples (turned by 10°)"});
  }
}

std::vector<Event> EventWatch::events() const {
  std::vector<Event> sorted = events_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Event& a, const Event& b) { return a.time < b.time; });
  return sorted;
}

}  // namespace talus
