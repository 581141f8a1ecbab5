#pragma once

#include <map>
#include <optional>
#include <utility>

#include "contact/passage/passage.hpp"

namespace talus {

/// Looks whether bodies lie in each other, by their shapes alone: it shares nothing with the search for contacts, so
/// that what that one has lost is seen.
class BodiesInEachOther {
 public:
  /// Bodies are where they are at first: what lies in each other then may.
  BodiesInEachOther(const BlockSystem& system, const BodySet& set);

  /// The pair that is deepest beyond what it may be: `allowed` of its mesh size, or twice as deep as it was at first.
  std::optional<DeepPair> look(const BodySet& set, double allowed);

 private:
  BodiesInEachOther(const BlockSystem& system, const BodySet& set, std::span<const Surface> surfaces);

  using Bodies = std::pair<int, int>;
  /// How deep two bodies lie in each other [m], along the direction in which that is least; of bodies in several pieces
  /// that of the two which are deepest. Depths up to `enough` count as none.
  std::optional<DeepPair> depth(const BodySet& set, Bodies bodies, double enough);
  template <class Visit>
  void visit_pairs(const BodySet& set, const Visit& visit);

  ConvexPieces pieces_;
  NearPieces near_;
  std::map<Bodies, double> at_first_;  // m, of those that lay in each other at first
  std::map<Bodies, Vec3> directions_;  // of whole bodies: along which they were apart last
  PlacedPiece first_, second_;
};

}  // namespace talus
