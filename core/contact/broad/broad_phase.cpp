#include "contact/broad/broad_phase.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "mesh/surface.hpp"

namespace talus {
namespace {

// The margin of a search for faces lasts so many steps at the pace of both bodies, within these fractions of the
// mesh size. Wider: fewer searches, but more pairs to filter in every step.
constexpr double steps_ahead = 20, least_margin = 0.05, most_margin = 0.2;
// Of what a pair has gone and is away: left for the rounding of sums.
constexpr double rounding = 1e-12;
constexpr std::size_t part_of_pairs = 8192;  // pairs of faces that are filtered in a tenth of a millisecond

}  // namespace

BroadPhase::BroadPhase(const ContactFeatures& features, std::span<const ContactBody> bodies,
                       const ContactSettings& settings, ContactWork& work)
    : features_(features),
      asleep_(bodies.size(), 0),
      settings_(settings),
      odometers_(bodies.size()),
      faces_(features, odometers_),
      neighbours_(bodies.size()),
      is_taken_(features.faces.size(), 0),
      work_(work) {
  set_bodies(bodies);
}

void BroadPhase::set_bodies(std::span<const ContactBody> bodies) {
  bodies_.assign(bodies.begin(), bodies.end());
  largest_size_ = 0;
  sizes_.clear();
  for (const ContactBody& b : bodies) {
    if (!b.fixed) largest_size_ = std::max(largest_size_, b.surface->size);
    sizes_.push_back(b.fixed ? std::numeric_limits<double>::infinity() : b.surface->size);
  }
  for (int b = 0; b < static_cast<int>(bodies.size()); ++b) stand(b);
  for (int p : listed_) begin(pairs_[p]);  // scales are others now
}

void BroadPhase::set_asleep(int body, bool asleep) {
  if (static_cast<bool>(asleep_[body]) == asleep) return;
  asleep_[body] = asleep;
  stand(body);
}

void BroadPhase::stand(int body) {
  const double widest = bodies_[body].fixed ? largest_size_ : bodies_[body].surface->size;
  neighbours_.set(body, {settings_.tolerances.largest_depth * widest, bodies_[body].surface->size, rests(body)});
}

void BroadPhase::moved(int body, double displacement) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  odometers_.add(body, displacement + epsilon * faces_.farthest_coordinate(body));
}

void BroadPhase::read_motion(std::span<const Vec3> x) {
  for (int b = 0; b < static_cast<int>(bodies_.size()); ++b) {
    const auto nodes = static_cast<int>(bodies_[b].surface->ring.size());
    if (!asleep_[b]) odometers_.read(b, bodies_[b].first_node, nodes, x);
  }
}

PairScale BroadPhase::scale(int body_a, int body_b) const {
  double compliance = 0;
  for (int b : {body_a, body_b})
    if (!bodies_[b].fixed) compliance += 1 / bodies_[b].young;
  const double smaller = size(body_a, body_b);
  return {smaller, settings_.stiffness / (compliance * smaller)};
}

double BroadPhase::search_distance(int body_a, int body_b, const Reach& reach) const {
  return std::max(reach(body_a, body_b), settings_.tolerances.largest_depth * size(body_a, body_b));
}

int BroadPhase::new_pair(int body_a, int body_b) {
  if (free_.empty()) {
    free_.push_back(static_cast<int>(pairs_.size()));
    pairs_.emplace_back();
  }
  const int number = free_.back();
  free_.pop_back();
  pairs_[number].a = body_a, pairs_[number].b = body_b;
  begin(pairs_[number]);
  return number;
}

void BroadPhase::begin(BodyPair& pair) const {
  pair.depth = search_distance(pair.a, pair.b, 0);
  pair.search_at = -1;
}

/// Pairs that stay neighbours keep what they have found.
void BroadPhase::list_neighbours() {
  const auto bodies = [&](int p) { return std::pair(pairs_[p].a, pairs_[p].b); };
  std::size_t kept = 0, next = 0;
  new_.clear();
  for (const auto& pair : neighbours_.pairs()) {
    while (next < listed_.size() && bodies(listed_[next]) < pair) free_.push_back(listed_[next++]);
    if (next < listed_.size() && bodies(listed_[next]) == pair) {
      listed_[kept++] = listed_[next++];
    } else {
      new_.push_back(pair);
    }
  }
  free_.insert(free_.end(), listed_.begin() + static_cast<long>(next), listed_.end());
  listed_.resize(kept);
  for (const auto& [a, b] : new_) listed_.push_back(new_pair(a, b));
  std::sort(listed_.begin(), listed_.end(), [&](int p, int q) { return bodies(p) < bodies(q); });
}

/// How far apart the bodies' boxes are, or at the least are if that is more than `worthwhile`.
double BroadPhase::distance_of(const BodyPair& pair, double worthwhile, std::span<const Vec3> x) {
  ++work_.body_pairs;
  const auto apart = [&] { return faces_.box_of(pair.a).apart(faces_.box_of(pair.b)); };
  const double least = apart() - faces_.gone_since(pair.a) - faces_.gone_since(pair.b);
  if (least > worthwhile) return least;
  faces_.refit(pair.a, x);
  faces_.refit(pair.b, x);
  return apart();
}

void BroadPhase::search(BodyPair& pair, std::span<const Vec3> x, double distance) {
  const double smaller = size(pair.a, pair.b), displacement = odometers_.pace(pair.a) + odometers_.pace(pair.b);
  const double margin = std::clamp(steps_ahead * displacement, least_margin * smaller, most_margin * smaller);
  const double apart = distance_of(pair, distance + margin, x);
  const auto when_within = [&](double d) { return (gone(pair) + d) * (1 - rounding); };
  pair.candidates.clear();
  pair.faces.clear();
  if (apart > distance + margin) {
    pair.search_at = pair.filter_at = when_within(apart);
    return;
  }
  found_.clear();
  faces_.pairs_within(pair.a, pair.b, distance + margin, found_);
  std::sort(found_.begin(), found_.end());
  take_candidates(pair);
  pair.search_at = when_within(distance + margin);
  pair.filter_at = pair.candidates.empty() ? pair.search_at : -1;
  ++work_.searches;
  work_.facet_pairs_searched += static_cast<long>(found_.size());
}

void BroadPhase::take_candidates(BodyPair& pair) {
  if (pair.candidates.capacity() < found_.size()) pair.candidates.reserve(2 * found_.size());  // once, as they slide on
  if (pair.faces.capacity() < found_.size()) pair.faces.reserve(2 * found_.size());
  for (const auto& [f, g] : found_) {
    pair.candidates.push_back({f, g});
    for (int face : {f, g}) {
      if (!is_taken_[face]) pair.faces.push_back(face);
      is_taken_[face] = 1;
    }
  }
  for (int face : pair.faces) is_taken_[face] = 0;
}

void BroadPhase::filter(BodyPair& pair, std::span<const Vec3> x, double distance, std::vector<FacePair>& near) {
  for (int f : pair.faces) faces_.refresh(f, x);
  const std::size_t first = near.size();
  for (const FacePair& f : pair.candidates) {
    if (faces_.box(f.a).within(faces_.box(f.b), distance)) near.push_back(f);
  }
  if (near.size() > first) return;
  double apart = std::numeric_limits<double>::infinity();
  for (const FacePair& f : pair.candidates) apart = std::min(apart, faces_.box(f.a).apart(faces_.box(f.b)));
  pair.filter_at = std::min(pair.search_at, (gone(pair) + apart) * (1 - rounding));
}

/// On all cores. What is near is joined in the order of the neighbours.
void BroadPhase::filter_due(std::span<const Vec3> x, const std::function<double(int, int)>& nearer) {
  int count = 0;
  std::size_t candidates = part_of_pairs;
  for (int i = 0; i < static_cast<int>(due_.size()); ++i) {
    if (candidates >= part_of_pairs) {
      if (count == static_cast<int>(parts_.size())) parts_.emplace_back();
      parts_[count++].first = i;
      candidates = 0;
    }
    candidates += pairs_[due_[i].pair].candidates.size();
    parts_[count - 1].last = i + 1;
    work_.facet_pairs += static_cast<long>(pairs_[due_[i].pair].candidates.size());
  }
  const auto filter_parts = [&](int first, int last) {
    for (Part& part : std::span(parts_).subspan(first, last - first)) {
      part.near.clear();
      for (int i = part.first; i < part.last; ++i) {
        BodyPair& pair = pairs_[due_[i].pair];
        const double distance = nearer ? std::min(due_[i].distance, nearer(pair.a, pair.b)) : due_[i].distance;
        if (distance >= 0) filter(pair, x, distance, part.near);
      }
    }
  };
  in_parallel(count, 1, std::ref(filter_parts));
  near_.clear();
  for (const Part& part : std::span(parts_).first(count)) near_.insert(near_.end(), part.near.begin(), part.near.end());
}

std::span<const FacePair> BroadPhase::find(std::span<const Vec3> x, const Reach& reach,
                                           const std::function<double(int, int)>& nearer) {
  faces_.forget(odometers_.moved());
  if (neighbours_.follow(x, reach, odometers_, faces_)) list_neighbours();
  due_.clear();
  for (int p : listed_) {
    BodyPair& pair = pairs_[p];
    const double distance = std::max(reach(pair.a, pair.b), pair.depth), now = gone(pair) + distance;
    if (!(now <= pair.search_at)) search(pair, x, distance);
    if (!(now <= pair.filter_at)) due_.push_back({p, distance});
  }
  filter_due(x, nearer);
  odometers_.have_seen();
  return near_;
}

}  // namespace talus
