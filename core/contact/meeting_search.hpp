#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "contact/contact_points.hpp"

namespace talus {

/// Corners that meet corners or convex creases: nothing there has a normal of its own. Both features are taken as
/// rounded, by as little as the bodies lie in each other: the normal points from the core of one to that of the other.
/// While they are apart that is the direction between the closest points; where they touch it lies between the normals
/// of the facets around and turns into one of them as the corner slides past. Edges that run along each other meet
/// at the ends of what they share, and where they cross at a small angle. Points of all other kinds must be there
/// already.
class MeetingSearch {
 public:
  MeetingSearch();

  /// `remembered` tells of a key whether its contact was closed at the end of the last step.
  void find(const StepGeometry& step, std::span<const FacetPair> pairs,
            const std::function<bool(std::uint64_t)>& remembered, FoundPoints& found);

  /// The step was accepted whose features find() saw last.
  void accept() { former_.swap(seen_); }

 private:
  /// A place on the surface of a body: a corner, or a point of a crease.
  struct Feature {
    int body;
    std::array<int, 2> nodes;  // the corner, or the ends of the edge that are within the rim; −1: none
    Vec3 place, core;
    std::vector<std::pair<int, Vec3>> faces;  // patches around, those of a corner within the rim too, and their normals
  };
  struct Place {
    int node;      // a corner; −1: on an edge, …
    int edge;      // … this one, …
    double share;  // … so far along
  };
  /// Two places nearest each other.
  struct Encounter {
    std::uint64_t key;
    Place own, other;
    double apart;  // m, of the cores
    bool own_is_first;
  };
  /// What was seen of a meeting: where the corner was, as seen from the feature, and whether it is known not to pass.
  struct Sight {
    std::uint64_t key;
    Vec3 from_feature;
    bool is_solid;
  };
  /// A body that presses on a patch.
  struct Pressure {
    int patch, by;
    Vec3 normal;  // towards the patch's body
    Vec3 place;   // m
    bool operator<(const Pressure& p) const { return patch < p.patch; }
  };

  static std::span<const int> facets_at(const ContactFeatures& features, const Place& place);
  static std::array<int, 2> ends_of(const ContactFeatures& features, const Place& place);
  static bool in_cone(const StepGeometry& step, const Place& place, const Vec3& inwards);
  static void take(const StepGeometry& step, const Place& place, double roundness, double rim, Feature& feature);
  void meet(const StepGeometry& step, int node, int edge, bool node_is_first);
  void meet_across(const StepGeometry& step, int edge_a, int edge_b);
  void list_facing(const FoundPoints& found);
  void list_pressures(const StepGeometry& step, const FoundPoints& found);
  void add(const StepGeometry& step, const Encounter& m, const std::function<bool(std::uint64_t)>& remembered,
           FoundPoints& found);
  std::optional<Vec3> normal_of(const StepGeometry& step, const Encounter& m, double roundness) const;
  bool facing_have_it(const StepGeometry& step, std::span<const int> facets, std::span<const int> others,
                      bool are_first);
  bool lies_flush(const StepGeometry& step, const Feature& own, const Feature& other) const;
  bool passes(const StepGeometry& step, std::uint64_t key, bool remembered);
  bool stands_for_others(const StepGeometry& step, const Vec3& normal, bool own_is_first, FoundPoints& found) const;

  std::vector<Encounter> meetings_;
  std::vector<std::uint64_t> facing_;  // families, sorted
  struct Flank {
    std::uint64_t family;
    Vec3 normal;
  };
  std::vector<Flank> flanks_;         // of the place that is looked at, on which patches face each other
  std::vector<Pressure> pressures_;   // sorted by patch
  std::vector<Sight> seen_, former_;  // sorted by key
  Feature own_, other_;
};

}  // namespace talus
