#include "contact/passage/near_pieces.hpp"

#include <algorithm>

namespace talus {

Box NearPieces::box_around(std::span<const int> nodes) const {
  Box box;
  for (const int n : nodes) {
    box.add(start_[n]);
    box.add(end_[n]);
  }
  return box;
}

/// Fixed bodies move without turning, if at all.
bool NearPieces::still_stands(const Body& body, Pieces& own) const {
  const Vec3 before = own.stood_at, &now = start_[body.first_node];
  const bool stands = body.built_fixed() && now == end_[body.first_node];
  own.stood_at = stands ? now : Vec3::Constant(std::numeric_limits<double>::infinity());
  return stands && now == before;
}

void NearPieces::set_span(std::span<const Vec3> start, std::span<const Vec3> end, const BodySet& bodies) {
  start_ = start;
  end_ = end;
  bodies_.resize(bodies.bodies.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = bodies.bodies[b];
    if (still_stands(body, of_pieces_[b])) continue;
    of_pieces_[b].fits = false;
    bodies_[b] = {};
    for (int n = body.first_node; n < body.first_node + body.node_count; ++n) {
      bodies_[b].add(start[n]);
      bodies_[b].add(end[n]);
    }
  }
  tree_.build(bodies_);
}

std::span<const int> NearPieces::near(int body) {
  found_.clear();
  tree_.within(bodies_[body], 0, bodies_, stack_, found_);
  std::erase(found_, body);
  std::sort(found_.begin(), found_.end());
  return found_;
}

const NearPieces::Pieces& NearPieces::fitted(int body) {
  Pieces& own = of_pieces_[body];
  if (own.fits) return own;
  own.boxes.clear();
  for (int i = 0; i < pieces_.count(body); ++i) own.boxes.push_back(box_around(pieces_.piece(body, i).nodes));
  if (own.built)
    own.tree.refit(own.boxes);
  else
    own.tree.build(own.boxes);
  own.built = own.fits = true;
  return own;
}

std::span<const std::pair<int, int>> NearPieces::near(int body_a, int body_b) {
  const Pieces &a = fitted(body_a), &b = fitted(body_b);
  pairs_.clear();
  a.tree.pairs_within(b.tree, 0, a.boxes, b.boxes, pair_stack_, pairs_);
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

}  // namespace talus
