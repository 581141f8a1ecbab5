#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/narrow/grouped.hpp"
#include "contact/narrow/near_features.hpp"
#include "contact/narrow/separating_axis.hpp"
#include "contact/points_by_bodies.hpp"

namespace talus {

/// What was seen of two features: where one was as seen from the other, and whether they are known not to pass.
struct Sight {
  std::uint64_t key;
  Vec3 from_feature;
  bool is_solid;

  void archive(auto& state) { state(key, from_feature, is_solid); }
};
using Sights = Grouped<Sight>;  ///< by a feature

void add_sights(std::span<const Sight> seen, Sights& sights);

/// A body that presses on a smooth face.
struct Pressure {
  int by;
  Vec3 normal;  ///< towards the body of the smooth face
  Vec3 place;   ///< m
};
using Pressures = Grouped<Pressure>;  ///< by smooth face

/// Adds those of points that were not dropped.
void add_pressures(std::span<const FoundPoint> points, const Reach& reach, Pressures& pressures);

/// Contact where no feature has a normal of its own: of a corner with a corner or with a convex sharp edge, and of
/// sharp edges along each other, at the ends of what they have in common and where they cross at a small angle. Both
/// features are taken as rounded, by as little as the bodies lie in each other: the normal points from the core of one
/// to that of the other. While they are apart that is the direction between the closest points; where they touch it
/// lies between the normals of the facets around and turns into one of them as the corner slides past. Points of all
/// other kinds must be there already.
class VertexVertexSearch {
 public:
  VertexVertexSearch();

  /// `pressures` on all bodies; `former`: what searches had seen() when the last step was accepted.
  void find(const StepGeometry& step, const NearFeatures& near, const Pressures& pressures, const Sights& former,
            SeparatingAxis& axis, FoundPoints& found);
  /// In this search.
  std::span<const Sight> seen() const { return seen_; }

 private:
  /// A place on the surface of a body, a corner or a point of a sharp edge, and what is around it.
  struct Feature {
    int body;
    std::array<int, 2> nodes;  // the corner, or the ends of the edge within the edge tolerance; −1: none
    Vec3 place, core;
    std::vector<std::pair<int, Vec3>> faces;  // smooth faces around, also at such ends, and their normals
  };
  struct Place {
    int node;         // a corner; −1: on an edge, …
    int edge;         // … this one, …
    double fraction;  // … at this fraction of its length
  };
  /// Two places nearest each other, which may touch.
  struct Candidate {
    std::uint64_t key;
    Place own, other;
    double apart;  // m, of the cores
    bool own_is_first;
  };
  static std::span<const int> facets_at(const ContactFeatures& features, const Place& place);
  static std::array<int, 2> ends_of(const ContactFeatures& features, const Place& place);
  static bool in_cone(const StepGeometry& step, const Place& place, const Vec3& inwards);
  void take(const StepGeometry& step, const Place& place, Feature& feature) const;
  void find_candidates(const StepGeometry& step, const NearFeatures::OfBodies& near);
  void add_vertex_at_edge(const StepGeometry& step, int node, int edge, bool node_is_first);
  void add_edge_along_edge(const StepGeometry& step, int edge_a, int edge_b);
  void list_face_face(const std::array<int, 2>& of_bodies, const FoundPoints& found);
  void add(const StepGeometry& step, const Candidate& m, SeparatingAxis& axis, FoundPoints& found);
  std::optional<Vec3> normal_of(const StepGeometry& step, const Candidate& m) const;
  bool face_face_holds(const StepGeometry& step, std::span<const int> facets, std::span<const int> others,
                       bool are_first);
  bool lies_flush(const StepGeometry& step, const Feature& own, const Feature& other) const;
  bool passes(const StepGeometry& step, std::uint64_t key);
  bool stands_for_others(const StepGeometry& step, const Vec3& normal, bool own_is_first, FoundPoints& found) const;

  // Of the two bodies that are looked at:
  std::vector<std::uint64_t> face_face_families_;  // sorted
  std::array<std::vector<int>, 2> in_face_face_;   // smooth faces of each in such contact, sorted
  std::vector<Candidate> candidates_;
  double depth_ = 0;           // m, how deep they can lie in each other
  double edge_tolerance_ = 0;  // m
  double far_ = 0;             // m, between a corner and an edge
  std::size_t first_ = 0;      // vertex–vertex contact that was found

  PointsByBodies others_;  // those that were there before
  struct AdjacentFace {
    std::uint64_t family;
    Vec3 normal;
  };
  std::vector<AdjacentFace> adjacent_faces_;  // at the place that is looked at: those in face–face contact
  const Pressures* pressures_ = nullptr;
  const Sights* former_ = nullptr;
  std::vector<Sight> seen_;
  Feature own_, other_;
};

}  // namespace talus
