#include "solve/event_watch.hpp"

#include <algorithm>

#include "base/units.hpp"
#include "bodies/block_motion.hpp"
#include "solve/simulation.hpp"

namespace talus {

namespace {

/// A contact that closes again within this time has only chattered [s].
constexpr double lasting = 0.25;
/// A block topples when it has turned by this much [degrees].
constexpr double toppling_angle = 10;

}  // namespace

EventWatch::EventWatch(const BlockSystem& system)
    : system_(system), blocks_(system.blocks.size()), turned_(system.blocks.size(), false) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) blocks_[b].what = system.blocks[b].name + " lost contact";
}

void EventWatch::settle(Watched& watched, double time) {
  if (watched.closed_now) {
    watched.was_closed = true;
    watched.told = false;
    watched.open_since = time;
  } else if (watched.was_closed && !watched.told && time - watched.open_since > lasting) {
    watched.told = true;
    watched.was_closed = false;
    events_.push_back({watched.open_since, watched.what});
  }
  watched.closed_now = false;
}

void EventWatch::look(const Simulation& simulation, const std::vector<ContactSample>& contacts) {
  for (const ContactSample& contact : contacts) {
    if (contact.state == ContactState::open) continue;
    const std::pair<int, int> pair = std::minmax(contact.blocks[0], contact.blocks[1]);
    Watched& joint = joints_[{pair, contact.joint}];
    if (joint.what.empty() && !system_.joint_names.empty())
      joint.what = system_.joint_names[contact.joint] + " opened (" + system_.blocks[pair.first].name + " - " +
                   system_.blocks[pair.second].name + ")";
    joint.closed_now = true;
    for (const int block : contact.blocks) blocks_[block].closed_now = true;
  }
  const double time = simulation.time();
  for (auto& [key, joint] : joints_) settle(joint, time);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (simulation.bodies().bodies[b].fixed) continue;
    settle(blocks_[b], time);
    if (turned_[b] || degrees(block_motion(simulation.bodies(), static_cast<int>(b)).rotation) < toppling_angle)
      continue;
    turned_[b] = true;
    events_.push_back({time, system_.blocks[b].name + " topples (turned by 10°)"});
  }
}

std::vector<Event> EventWatch::events() const {
  std::vector<Event> sorted = events_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Event& a, const Event& b) { return a.time < b.time; });
  return sorted;
}

}  // namespace talus
