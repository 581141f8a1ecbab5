#include "solve/late_contacts.hpp"

#include <algorithm>

namespace talus {

bool LateContacts::turns(const Increment& d, double least_turn) const {
  return std::any_of(set_.moving.begin(), set_.moving.end(), [&](int b) {
    const Body& body = set_.bodies[b];
    const int nodes_end = body.first_node + body.node_count;
    Vec3 mean = Vec3::Zero();
    for (int n = body.first_node; n < nodes_end; ++n) mean += set_.node_increment(n, d) / body.node_count;
    for (int n = body.first_node; n < nodes_end; ++n)
      if ((set_.node_increment(n, d) - mean).norm() >= least_turn) return true;
    return false;
  });
}

void LateContacts::place_nodes(const Increment& d) {
  end_ = set_.nodes.position;
  std::fill(ways_.begin(), ways_.end(), 0.0);
  for (const auto* moved : {&set_.moving, &set_.driven})
    for (const int b : *moved) {
      const Body& body = set_.bodies[b];
      for (int n = body.first_node; n < body.first_node + body.node_count; ++n) {
        const Vec3 step = set_.node_increment(n, d);
        end_[n] += step;
        ways_[b] = std::max(ways_[b], step.norm());
      }
    }
}

void LateContacts::tell(ContactDetector& detector) const {
  for (std::size_t b = 0; b < ways_.size(); ++b)
    if (ways_[b] > 0) detector.moved(static_cast<int>(b), ways_[b]);
}

double LateContacts::known_depth(const ContactDetector::Late& late, const ContactLinks& links,
                                 const Increment& d) const {
  double deepest = 0;
  for (int i = 0; i < links.moves().size(); ++i) {
    const ContactPoint& point = links.point(i);
    if (point.bodies[0] != late.bodies[0] || point.bodies[1] != late.bodies[1]) continue;
    deepest = std::max(deepest, (point.overlap - links.gap(i, d)) / point.size);
  }
  return deepest;
}

std::optional<ContactDetector::Late> LateContacts::seek(ContactDetector& detector, const ContactLinks& links,
                                                        const Increment& d, double reach, double tolerance,
                                                        double least_turn) {
  if (!turns(d, least_turn)) return std::nullopt;
  place_nodes(d);
  tell(detector);
  std::optional<ContactDetector::Late> deepest;
  for (const ContactDetector::Late& late : detector.late(end_, reach, tolerance)) {
    if (deepest && late.depth <= deepest->depth) continue;
    // However deep others lie: one that is deeper than they may be, and as much again, is unforeseen.
    if (late.depth > tolerance + std::min(tolerance, known_depth(late, links, d))) deepest = late;
  }
  tell(detector);
  return deepest;
}

}  // namespace talus
