#include "contact/narrow/point_search.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "base/parallel.hpp"

namespace talus {
namespace {

constexpr std::size_t part_size = 1024;  // pairs of facets: a quarter of a millisecond's work
constexpr int points_worth_a_thread = 512;

/// Of the size: pairs of facets that are farther than the reach by less are kept, for two measures of one gap
/// differ by rounding. What is kept for nothing is found to be no contact.
constexpr double reach_slack = 1e-9;
/// Of a depth that is asked for: so deep along all directions are bodies with a point of that depth, but for rounding.
constexpr double clearly_deep = 1 - 1e-6;

}  // namespace

double PointSearch::distance(const StepGeometry& step, int body_a, int body_b) const {
  const bool by_facets = settings_.model == ContactModel::facet_wise;
  const double most =
      by_facets ? step.broad.search_distance(body_a, body_b, step.reach) : step.search_distance(body_a, body_b);
  return most + reach_slack * step.broad.size(body_a, body_b);
}

void PointSearch::divide(const ContactFeatures& features, std::span<const FacePair> pairs) {
  const auto bodies = [&](std::size_t i) {
    return std::pair(features.faces[pairs[i].a].body, features.faces[pairs[i].b].body);
  };
  part_count_ = 0;
  for (std::size_t begin = 0, end = 0; begin < pairs.size(); begin = end) {
    end = std::min(begin + part_size, pairs.size());
    while (end < pairs.size() && bodies(end) == bodies(end - 1)) ++end;
    if (part_count_ == static_cast<int>(parts_.size())) parts_.emplace_back(settings_.tolerances);
    parts_[part_count_++].pairs = pairs.subspan(begin, end - begin);
  }
}

template <class Work>
void PointSearch::each_part(const Work& work) {
  const auto of_range = [&](int first, int last) {
    for (int i = first; i < last; ++i) work(parts_[i]);
  };
  in_parallel(part_count_, 1, std::ref(of_range));
}

void PointSearch::find_near(const StepGeometry& step, Part& part) const {
  part.near.find(step, part.pairs, [&](int a, int b) { return distance(step, a, b); });
}

void PointSearch::find(const StepGeometry& step, std::span<const FacePair> pairs, FoundPoints& found) {
  divide(step.features, pairs);
  if (settings_.model == ContactModel::facet_wise) {
    each_part([&](Part& part) {
      find_near(step, part);
      part.found.clear();
      part.facet_wise.find(step, part.near.faces(), part.found);
    });
  } else {
    search_features(step);
    search_corners(step);
  }
  join(found);
}

/// The pairs of faces of bodies of which one may be deeper than this, of the mesh size, in any other.
std::span<const FacePair> PointSearch::of_deep_bodies(const StepGeometry& step, std::span<const FacePair> pairs,
                                                      double depth) {
  divide(step.features, pairs);
  each_part([&](Part& part) {
    part.axis.begin();
    part.deep_bodies.clear();
    visit_body_pairs(step.features, part.pairs, [&](std::span<const FacePair> of_bodies) {
      const int a = step.features.faces[of_bodies[0].a].body, b = step.features.faces[of_bodies[0].b].body;
      if (part.axis.refutes(step, a, b, -clearly_deep * depth * step.broad.size(a, b))) return;
      part.deep_bodies.insert(part.deep_bodies.end(), {a, b});
    });
  });
  is_deep_.assign(step.widths.size(), 0);
  for (int i = 0; i < part_count_; ++i)
    for (const int body : parts_[i].deep_bodies) is_deep_[body] = 1;
  of_deep_.clear();
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(of_deep_), [&](const FacePair& pair) {
    return is_deep_[step.features.faces[pair.a].body] || is_deep_[step.features.faces[pair.b].body];
  });
  return of_deep_;
}

void PointSearch::find_ahead(const StepGeometry& step, std::span<const FacePair> pairs, double depth,
                             FoundPoints& found) {
  divide(step.features, of_deep_bodies(step, pairs, depth));
  search_features(step);
  join(found);
}

/// Face–face contact, vertices on faces and edges that cross.
void PointSearch::search_features(const StepGeometry& step) {
  each_part([&](Part& part) {
    find_near(step, part);
    part.found.clear();
    part.axis.begin();
    part.face_face.find(step, part.near.facing(), part.axis, part.found);
    part.vertex_face.find(step, part.near, part.axis, part.found);
  });
  false_vertices_.clear();
  for (int i = 0; i < part_count_; ++i) false_vertices_.add(step, parts_[i].found);
  false_vertices_.drop(step);
  each_part([&](Part& part) {
    std::erase_if(part.found.points,
                  [](const FoundPoint& point) { return point.dropped; });  // most, where bodies lie flush
    part.edge_edge.find(step, part.near, part.vertex_face, part.axis, part.found);
  });
}

/// Vertex–vertex contact.
void PointSearch::search_corners(const StepGeometry& step) {
  pressures_.clear();
  for (int i = 0; i < part_count_; ++i) add_pressures(parts_[i].found.points, step.reach, pressures_);
  each_part([&](Part& part) { part.vertex_vertex.find(step, part.near, pressures_, former_, part.axis, part.found); });
  seen_.clear();
  for (int i = 0; i < part_count_; ++i) add_sights(parts_[i].vertex_vertex.seen(), seen_);
}

void PointSearch::join(FoundPoints& found) {
  places_.clear();
  for (int part = 0; part < part_count_; ++part) {
    const std::vector<FoundPoint>& points = parts_[part].found.points;
    for (std::size_t i = 0; i < points.size(); ++i) places_.push_back({points[i].key, part, static_cast<int>(i), 0});
  }
  std::sort(places_.begin(), places_.end(), [](const Place& p, const Place& q) { return p.key < q.key; });
  int stencils_end = 0;
  for (Place& place : places_) {
    const FoundPoint& p = parts_[place.part].found.points[place.point];
    place.stencil_begin = stencils_end;
    stencils_end += p.stencil_end - p.stencil_begin;
  }
  found.points.resize(places_.size());
  found.nodes.resize(stencils_end);
  found.weights.resize(stencils_end);
  const auto copy = [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const Place& place = places_[i];
      const FoundPoints& from = parts_[place.part].found;
      FoundPoint& p = found.points[i];
      p = from.points[place.point];
      std::copy(from.nodes.begin() + p.stencil_begin, from.nodes.begin() + p.stencil_end,
                found.nodes.begin() + place.stencil_begin);
      std::copy(from.weights.begin() + p.stencil_begin, from.weights.begin() + p.stencil_end,
                found.weights.begin() + place.stencil_begin);
      p.stencil_end += place.stencil_begin - p.stencil_begin;
      p.stencil_begin = place.stencil_begin;
    }
  };
  in_parallel(static_cast<int>(places_.size()), points_worth_a_thread, std::ref(copy));
}

}  // namespace talus
