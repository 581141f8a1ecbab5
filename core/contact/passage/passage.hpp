#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <unordered_map>

#include "contact/passage/near_pieces.hpp"
#include "contact/passage/widest_gap.hpp"

namespace talus {

/// Two bodies that lie in each other, deeper than they may.
struct DeepPair {
  int bodies[2];
  Vec3 position;  ///< m, of a corner of the one that is less wide there
  double depth;   ///< m, so far have they to go to part
  double size;    ///< m, the mesh size of the two, that of the finer
};

/// Whether a step takes bodies through each other. The search for contacts sees where a step begins; a body that goes
/// further in it than it is thick may leave on the far side, or deeper in than a search finds it again. Looked at are
/// pairs of bodies of which one goes further against the other than half their thickness. They have not touched if a
/// plane parts them at both ends of a span of time: with nodes on straight lines its gap is never less in between.
/// Where there is none the span is halved. So bodies that keep their shape are followed along the arcs that their
/// steps are; what they deform meanwhile goes along straight lines. Contacts hold bodies apart at the ends of a step:
/// on the way they may be deeper by as much as their arcs leave their chords.
class PassageCheck {
 public:
  PassageCheck(const BlockSystem& system, const BodySet& set, std::span<const Surface> surfaces);

  /// The first pair, in order of numbers, that an increment takes deeper into each other on its way than `tolerance` of
  /// their mesh size beyond `known(a, b)` [m], what contacts say of them, or beyond how deep they were at the start.
  /// Bodies that are `alone`, a flag each, can touch nobody.
  std::optional<DeepPair> find(const Increment& d, double tolerance,
                               const std::function<double(int body_a, int body_b)>& known, std::span<const char> alone);

 private:
  struct Moment {
    double time;  // of the step, 0…1
    Gap gap;
  };
  bool any_goes_far(const Increment& d, std::span<const char> alone);
  void measure(const Increment& d);
  std::optional<DeepPair> look(int a, int b, double size, double tolerance, double known);
  double bend(int body) const;
  bool stay_apart(const ConvexPiece& a, const ConvexPiece& b, const Moment& from, const Moment& to, int halvings);
  void place(const ConvexPiece& a, const ConvexPiece& b, double time);
  Moment at(const ConvexPiece& a, const ConvexPiece& b, double time);
  Vec3 position(int node, double time);
  const Increment& part(double time);

  ConvexPieces pieces_;
  const BodySet& set_;
  double thinnest_ = std::numeric_limits<double>::infinity();  // m, of all bodies
  NearPieces near_;
  const Increment* increment_ = nullptr;
  std::vector<Vec3> end_;                        // m, of all nodes
  std::vector<Vec3> displacements_;              // m, a body: the mean of its nodes
  std::vector<double> rotations_;                // m, a body: the farthest that a node goes against that
  std::vector<int> far_;                         // bodies that go far
  std::unordered_map<double, Increment> parts_;  // of the increment, at times in between
  PlacedPiece first_, second_;
  // Of the pair that is looked at [m]: how deep it may be at the end, and how much deeper on the way, how it moves, and
  // how far arcs leave their chords.
  double limit_ = 0, between_ = 0, motion_ = 0, bend_ = 0;
  Moment deep_;  // when it was first seen to be deeper
};

}  // namespace talus
