#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/facet_tree.hpp"
#include "contact/features.hpp"

namespace talus {

/// What two bodies' contact is measured against.
struct PairScale {
  double size;       ///< m, the smaller mesh size; a fixed body does not count
  double stiffness;  ///< Pa/m, κE*/h
};

/// A facet of the body with the lower number and one of the other.
struct FacetPair {
  int a, b;
  bool operator<(const FacetPair& o) const { return a != o.a ? a < o.a : b < o.b; }
};

/// Finds the pairs of facets whose boxes are near each other: bodies by sorting their boxes along x and sweeping,
/// facets by the bodies' trees. Pairs found are kept with a margin and only filtered until something has moved further
/// than it.
class BroadPhase {
 public:
  BroadPhase(const ContactFeatures& features, std::span<const ContactBody> bodies, const ContactSettings& settings);

  /// Some bodies are held from now on, or no longer.
  void set_bodies(std::span<const ContactBody> bodies);

  /// Sorted pairs of facets whose boxes are within the search distance of their bodies at positions x. What is found
  /// does not depend on earlier calls.
  std::span<const FacetPair> find(std::span<const Vec3> x, double reach);

  /// How far apart the features of two bodies may lie and yet touch: the reach outside, the depth inside.
  double search_distance(int body_a, int body_b, double reach) const;
  PairScale scale(int body_a, int body_b) const;

  /// Unit normals of the facets at the last positions; only those of facets in the pairs found are up to date.
  std::span<const Vec3> normals() const { return normals_; }

 private:
  bool still_valid(std::span<const Vec3> x, double reach) const;
  void search(std::span<const Vec3> x, double reach);
  void find_body_pairs(double distance);
  void update_facet(int facet, std::span<const Vec3> x);
  std::span<const Box> boxes_of(int body) const;

  const ContactFeatures& features_;
  std::vector<ContactBody> bodies_;
  ContactSettings settings_;
  double margin_ = 0;

  std::vector<Box> boxes_;     // a facet
  std::vector<Vec3> normals_;  // a facet
  std::vector<FacetTree> trees_;
  std::vector<int> sweep_;  // bodies by the lower side of their boxes along x
  std::vector<std::pair<int, int>> body_pairs_, stack_, found_;
  std::vector<FacetPair> candidates_, near_;
  std::vector<int> touched_;  // facets among the candidates
  std::vector<char> is_touched_;
  std::vector<Vec3> searched_at_;
  double searched_reach_ = -1;
};

}  // namespace talus
