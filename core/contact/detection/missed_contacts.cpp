#include "contact/detection/missed_contacts.hpp"

#include <algorithm>

namespace talus {

namespace {

bool is_alone(int body, std::span<const char> alone) { return !alone.empty() && alone[body]; }

/// Of a contact of the step [mesh sizes]; negative where it is open.
double depth_of(int number, const ContactLinks& links, const Increment& d) {
  const ContactPoint& point = links.point(number);
  return (point.initial_interference - links.gap(number, d)) / point.size;
}

}  // namespace

void MissedContacts::measure_ways(const Increment& d, std::span<const char> alone) {
  std::fill(gone_.ways.begin(), gone_.ways.end(), BodyWay{});
  for (const int b : set_.driven) gone_.ways[b].mean = set_.nodes.prescribed[set_.bodies[b].first_node];
  for (const int b : set_.moving) {
    if (is_alone(b, alone)) continue;
    const Body& body = set_.bodies[b];
    const int nodes_end = body.first_node + body.node_count;
    for (int n = body.first_node; n < nodes_end; ++n) increments_[n] = set_.node_increment(n, d);
    const auto motion = [&](int node) -> const Vec3& { return increments_[node]; };
    gone_.ways[b] = way_of(body.first_node, body.node_count, motion);
  }
}

/// Whether some body rotates, or may have gone farther against another than was foreseen: that needs two that left
/// their foreseen ways by more than the least reach together.
bool MissedContacts::may_have_missed(const Reach& foreseen, double least_rotation) const {
  if (foreseen.ways.empty()) return true;
  for (std::size_t b = 0; b < gone_.ways.size(); ++b) {
    const BodyWay& way = gone_.ways[b];
    const double astray = (way.mean - foreseen.ways[b].mean).norm() + way.beside;
    if (way.beside >= least_rotation || 2 * astray > foreseen.least) return true;
  }
  return false;
}

void MissedContacts::place_nodes(std::span<const char> alone) {
  end_ = set_.nodes.position;
  std::fill(displacements_.begin(), displacements_.end(), 0.0);
  const auto place = [&](int b, const std::vector<Vec3>& increments) {
    if (is_alone(b, alone)) return;
    const Body& body = set_.bodies[b];
    for (int n = body.first_node; n < body.first_node + body.node_count; ++n) {
      end_[n] += increments[n];
      displacements_[b] = std::max(displacements_[b], increments[n].norm());
    }
  };
  for (const int b : set_.moving) place(b, increments_);
  for (const int b : set_.driven) place(b, set_.nodes.prescribed);
}

void MissedContacts::tell(ContactDetector& detector) const {
  for (std::size_t b = 0; b < displacements_.size(); ++b)
    if (displacements_[b] > 0) detector.moved(static_cast<int>(b), displacements_[b]);
}

double MissedContacts::known_depth(const ContactDetector::MissedContact& contact, const ContactLinks& links,
                                   const Increment& d) const {
  double deepest = 0;
  for (int i = 0; i < links.moves().size(); ++i) {
    const ContactPoint& point = links.point(i);
    if (point.bodies[0] != contact.bodies[0] || point.bodies[1] != contact.bodies[1]) continue;
    deepest = std::max(deepest, depth_of(i, links, d));
  }
  return deepest;
}

std::span<const ContactDetector::MissedContact> MissedContacts::seek(ContactDetector& detector,
                                                                     const ContactLinks& links, const Increment& d,
                                                                     const Reach& foreseen, double tolerance,
                                                                     double least_rotation,
                                                                     std::span<const char> alone) {
  missed_.clear();
  measure_ways(d, alone);
  if (!may_have_missed(foreseen, least_rotation)) return {};
  gone_.least = foreseen.least;
  gone_.multiple = foreseen.multiple;
  place_nodes(alone);
  tell(detector);
  for (const ContactDetector::MissedContact& contact :
       detector.missed_contacts(set_.nodes.position, end_, gone_, tolerance)) {
    if (contact.given >= 0 && contact.depth <= tolerance + depth_of(contact.given, links, d)) continue;
    const double known = known_depth(contact, links, d);
    // However deep others lie, one that is twice as deep as they may be was missed. What is deeper than the bodies have
    // come nearer there in this step lay there before it, and a shorter step would find it again.
    if (contact.depth > tolerance + std::min(tolerance, known) && contact.depth <= known + contact.approach)
      missed_.push_back(contact);
  }
  tell(detector);
  std::sort(missed_.begin(), missed_.end(),
            [](const auto& p, const auto& q) { return p.depth != q.depth ? p.depth > q.depth : p.number < q.number; });
  return missed_;
}

}  // namespace talus
