#include "contact/broad_phase.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace talus {
namespace {

// Of the smallest mesh size. Wider: fewer searches, but more pairs to filter in every step.
constexpr double margin_factor = 0.05;

}  // namespace

BroadPhase::BroadPhase(const ContactFeatures& features, std::span<const ContactBody> bodies,
                       const ContactSettings& settings)
    : features_(features), settings_(settings) {
  boxes_.resize(features.facets.size());
  normals_.resize(features.facets.size(), Vec3::Zero());
  is_touched_.resize(features.facets.size(), 0);
  sweep_.resize(bodies.size());
  std::iota(sweep_.begin(), sweep_.end(), 0);
  set_bodies(bodies);
}

void BroadPhase::set_bodies(std::span<const ContactBody> bodies) {
  bodies_.assign(bodies.begin(), bodies.end());
  searched_at_.clear();
  double smallest = std::numeric_limits<double>::infinity();
  for (const ContactBody& b : bodies) {
    if (!b.fixed) smallest = std::min(smallest, b.surface->size);
  }
  margin_ = std::isfinite(smallest) ? margin_factor * smallest : 0;
}

PairScale BroadPhase::scale(int body_a, int body_b) const {
  double size = std::numeric_limits<double>::infinity(), compliance = 0;
  for (int b : {body_a, body_b}) {
    if (bodies_[b].fixed) continue;
    size = std::min(size, bodies_[b].surface->size);
    compliance += 1 / bodies_[b].young;
  }
  return {size, settings_.stiffness / (compliance * size)};
}

double BroadPhase::search_distance(int body_a, int body_b, double reach) const {
  return std::max(reach, settings_.depth * scale(body_a, body_b).size);
}

std::span<const Box> BroadPhase::boxes_of(int body) const {
  const int begin = features_.facet_begin[body], end = features_.facet_begin[body + 1];
  return std::span(boxes_).subspan(begin, end - begin);
}

void BroadPhase::update_facet(int facet, std::span<const Vec3> x) {
  const auto& n = features_.facets[facet].nodes;
  Box box;
  for (int k : n) box.add(x[k]);
  boxes_[facet] = box;
  normals_[facet] = (x[n[1]] - x[n[0]]).cross(x[n[2]] - x[n[0]]).stableNormalized();
}

bool BroadPhase::still_valid(std::span<const Vec3> x, double reach) const {
  if (searched_at_.empty()) return false;
  const double allowed = (margin_ - std::max(0.0, reach - searched_reach_)) / 2;
  for (int i = 0; i < features_.node_count(); ++i) {
    if (!((x[i] - searched_at_[i]).lpNorm<Eigen::Infinity>() <= allowed)) return false;
  }
  return true;
}

void BroadPhase::find_body_pairs(double distance) {
  const auto lower = [&](int b) { return trees_[b].box().lower.x(); };
  std::sort(sweep_.begin(), sweep_.end(),
            [&](int a, int b) { return lower(a) != lower(b) ? lower(a) < lower(b) : a < b; });
  body_pairs_.clear();
  for (std::size_t i = 0; i < sweep_.size(); ++i) {
    const Box& box = trees_[sweep_[i]].box();
    for (std::size_t j = i + 1; j < sweep_.size() && lower(sweep_[j]) <= box.upper.x() + distance; ++j) {
      if (bodies_[sweep_[i]].fixed && bodies_[sweep_[j]].fixed) continue;
      if (box.within(trees_[sweep_[j]].box(), distance)) body_pairs_.push_back(std::minmax(sweep_[i], sweep_[j]));
    }
  }
}

void BroadPhase::search(std::span<const Vec3> x, double reach) {
  const bool first = trees_.empty();
  for (int b = 0; b < static_cast<int>(bodies_.size()); ++b) {
    for (int f = features_.facet_begin[b]; f < features_.facet_begin[b + 1]; ++f) update_facet(f, x);
    if (first) {
      trees_.emplace_back(features_.facet_begin[b], boxes_of(b));
    } else {
      trees_[b].refit(boxes_of(b));
    }
  }
  double widest = reach;
  for (const ContactBody& b : bodies_) {
    if (!b.fixed) widest = std::max(widest, settings_.depth * b.surface->size);
  }
  find_body_pairs(widest + margin_);

  for (int f : touched_) is_touched_[f] = 0;
  touched_.clear();
  candidates_.clear();
  for (const auto& [a, b] : body_pairs_) {
    found_.clear();
    trees_[a].pairs_within(trees_[b], search_distance(a, b, reach) + margin_, boxes_of(a), boxes_of(b), stack_, found_);
    for (const auto& [f, g] : found_) {
      candidates_.push_back({f, g});
      for (int facet : {f, g}) {
        if (is_touched_[facet]) continue;
        is_touched_[facet] = 1;
        touched_.push_back(facet);
      }
    }
  }
  std::sort(candidates_.begin(), candidates_.end());
  searched_at_.assign(x.begin(), x.begin() + features_.node_count());
  searched_reach_ = reach;
}

std::span<const FacetPair> BroadPhase::find(std::span<const Vec3> x, double reach) {
  if (still_valid(x, reach)) {
    for (int f : touched_) update_facet(f, x);
  } else {
    search(x, reach);
  }
  near_.clear();
  int body_a = -1, body_b = -1;
  double distance = 0;
  for (const FacetPair& pair : candidates_) {
    const int a = features_.facets[pair.a].body, b = features_.facets[pair.b].body;
    if (a != body_a || b != body_b) {
      body_a = a, body_b = b;
      distance = search_distance(a, b, reach);
    }
    if (boxes_[pair.a].within(boxes_[pair.b], distance)) near_.push_back(pair);
  }
  return near_;
}

}  // namespace talus
