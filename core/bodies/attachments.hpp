#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "bodies/body_set.hpp"
#include "bodies/meeting.hpp"
#include "bodies/pair_tangent.hpp"
#include "bodies/step_context.hpp"
#include "linear/symmetric_blocks.hpp"
#include "linear/unsymmetric_blocks.hpp"

namespace talus {

/// A force, or a moment over the radius of a rigid body, on a degree-of-freedom block.
struct BlockForce {
  int dof_block;
  Vec3 force;  ///< N
};

/// Points that are fixed to bodies, or differences of such points, as the unknowns of a step move them
/// (docs/theory.md):
///   u(D) = u₀ + Σ weight·D_block + Σ (exp(θ̂) − 1) arm  [m]
/// with one term of the first kind a node of tetrahedra, four an affine body and one a rigid body, which has one of the
/// second. u₀ is what nodes do that are moved by prescription. Contacts, loads and constraints know bodies by this
/// alone.
class Attachments {
 public:
  explicit Attachments(const BodySet& set) : set_(set) {}

  /// Forgets all points.
  void clear();
  /// A point at Σ weight·node: the bodies stand at the start of the step. Points are numbered from 0.
  void add(std::span<const int> nodes, std::span<const double> weights);
  int size() const { return static_cast<int>(points_.size()); }
  /// Whether the last point added is that of one rigid body against another, both of which move.
  bool may_meet() const;
  /// Then they meet from now on (Meeting) where the first (0) or the second (1) of them has it.
  void let_meet(int carrier);

  /// u(D) [m].
  Vec3 increment(int point, const Increment& d) const;
  /// sum += Jᵀ force with J = ∂u/∂D, where rotations turn the body on from D (BodySet::advance), or with the mean of J
  /// over the step: a force on the point, as forces and moments on the bodies [N].
  void add_force(int point, const Increment& d, const Vec3& force, Arms arms, Eigen::VectorXd& sum) const;
  /// sum += Jᵀ spring J [N/m] at a point that does not meet; `spring` is symmetric.
  void add_spring(int point, const Increment& d, const Mat3& spring, SymmetricBlocks& sum) const;
  /// sum += ∂/∂D of what add_force adds, at a constant force at a point that does not meet: the arms of turning bodies
  /// change [N/m].
  void add_turning(int point, const Increment& d, const Vec3& force, Arms arms, UnsymmetricBlocks& sum) const;
  class Forces;
  class PairSums;
  class Tangent;
  /// What the points of a pair of bodies that meet add to the derivative [N/m].
  struct PairSum {
    int point;                                          ///< one of them
    std::array<int, RigidPair::part_count> dof_blocks;  ///< RigidPair::dof_blocks
    PairBlocks symmetric, unsymmetric;
  };
  /// Looks for the places of all points in a pattern, unless it has: before several threads add to such a matrix.
  void find_slots(const BlockPattern& pattern) const;
  /// Columns of the lower triangle, with the rows that mirror them.
  struct Columns {
    int first, end;
    bool have(int dof_block) const { return first <= dof_block && dof_block < end; }
  };
  /// Adds what of the pairs lies in these columns; null: it is not asked for. Once there is room for them, several
  /// threads may add to columns of their own.
  void add(std::span<const PairSum> pairs, SymmetricBlocks* symmetric, UnsymmetricBlocks* unsymmetric,
           Columns columns = {0, std::numeric_limits<int>::max()}) const;
  void make_room(std::span<const PairSum> pairs, UnsymmetricBlocks& unsymmetric) const;
  /// Of a point that does not meet; null: it is not asked for.
  void add_tangent(int point, const Increment& d, Arms arms, const PointTangent& at, SymmetricBlocks* symmetric,
                   UnsymmetricBlocks* unsymmetric) const;
  bool meets(int point) const { return points_[point].meeting >= 0; }
  /// Whether some point lies on a rigid body: else add_turning adds nothing.
  bool any_turns() const { return !turns_.empty(); }
  /// The most negative change of direction·u that there can be when each degree-of-freedom block goes on from D by a
  /// fraction of its own, 0 to 1, of `change`, to first order in the change [m].
  double farthest_against(int point, const Increment& d, const Vec3& direction, const Eigen::VectorXd& change) const;
  /// Whether the bodies that move the point belong together; the degree-of-freedom blocks of each do.
  bool bodies_are_together(int point, DisjointSets& sets) const;
  /// From now on they do.
  void join_bodies(int point, DisjointSets& together) const;
  /// force·u₀ [J].
  double work_on_held(int point, const Vec3& force) const { return force.dot(points_[point].held); }

 private:
  struct Term {
    int dof_block;
    double weight;
  };
  struct Turn {
    int dof_block;
    double radius;           // m
    Vec3 arm;                // m, at the start of the step, times the weights
    const RigidBody* rigid;  // whose rotation it is
    // Every contact effect asks for the same few D one after the other: the last one's answer is kept.
    mutable Vec3 unknowns = Vec3::Zero();  // radius·θ
    mutable Vec3 moved = Vec3::Zero();     // (exp(θ̂) − 1) arm
    mutable double stretch = 1;            // tan(|θ|/2) over |θ|/2, or 1 of a body that touches others
  };
  struct Point {
    int term_begin, term_end, turn_begin, turn_end;
    Vec3 held;
    int pair = -1, meeting = -1;  // into pairs_ and meetings_
    int terms() const { return term_end - term_begin; }
    int turns() const { return turn_end - turn_begin; }
  };
  /// Where a pattern has the pairs of a point's degree-of-freedom blocks. They are numbered by its terms and then by
  /// its turns.
  class Slots {
   public:
    Slots(const Attachments& attachments, int point, const BlockPattern& pattern);
    int of_terms(int a, int b) const { return of(a - point_.term_begin, b - point_.term_begin); }
    int of_turn_and_term(int turn, int term) const { return of(number(turn), term - point_.term_begin); }
    int of_turns(int a, int b) const { return of(number(a), number(b)); }
    int of(int a, int b) const { return a >= b ? first_[a * (a + 1) / 2 + b] : first_[b * (b + 1) / 2 + a]; }

   private:
    int number(int turn) const { return point_.terms() + turn - point_.turn_begin; }
    const Point& point_;
    const int* first_;
  };
  /// The same of the parts of a pair, whose blocks are those of the first centroid up to a sign where it is a second.
  class PairSlots {
   public:
    PairSlots(const Attachments& attachments, int point, const BlockPattern& pattern);
    int of(int a, int b) const { return slots_.of(numbers_[a], numbers_[b]); }
    static Mat3 block(const PairBlocks& blocks, int a, int b) {
      const bool opposite = (a == RigidPair::second_centre) != (b == RigidPair::second_centre);
      return (opposite ? -1 : 1) * blocks[std::max(a - 1, 0)][std::max(b - 1, 0)];
    }

   private:
    Slots slots_;
    std::array<int, RigidPair::part_count> numbers_ = {0, 1, 2, 3};
  };
  void add_term(int first, int dof_block, double weight);
  void add_turn(int first, const RigidBody& rigid, int node, double weight);
  static const Vec3& moved_by(const Turn& turn, const Increment& d) {
    if (d.segment<3>(3 * turn.dof_block) != turn.unknowns) move(turn, d);
    return turn.moved;
  }
  static void move(const Turn& turn, const Increment& d);
  static Vec3 arm_at(const Turn& turn, const Increment& d) { return turn.arm + moved_by(turn, d); }
  /// Calls use(degree-of-freedom block, force on it) of a force at a point that does not meet.
  template <class Use>
  void visit_force(const Point& point, const Increment& d, const Vec3& force, Arms arms, const Use& use) const;
  /// With which a force turns the body.
  static Vec3 lever_at(const Turn& turn, const Increment& d, Arms arms);
  /// With mean arms: what sum += Jᵀ spring J of a spring at the point lacks, since Jᵀ has other arms than J [N/m]. With
  /// those at the end, nothing.
  void add_lever_difference(int point, const Increment& d, const Mat3& spring, Arms arms, UnsymmetricBlocks& sum) const;
  /// The same as add_spring for a matrix that is not symmetric.
  void add_other_spring(int point, const Increment& d, const Mat3& spring, UnsymmetricBlocks& sum) const;
  const RigidPair& pair_of(const Point& point) const { return pairs_[point.pair]; }

  const BodySet& set_;
  std::vector<Point> points_;
  std::vector<Term> terms_;
  std::vector<Turn> turns_;
  std::vector<RigidPair> pairs_;  // those that follow one upon the other differ
  std::vector<Meeting> meetings_;
  // Pairs of all points, each with those before it and itself, in the pattern that was asked for last:
  mutable std::uint64_t pattern_ = 0;    // 0: none since the last point was added
  mutable std::vector<int> slot_begin_;  // a point
  mutable std::vector<int> slots_;
};

/// Forces of several kinds at points, as what they are on degree-of-freedom blocks, a list a kind, three at most [N].
/// What points that follow one upon the other between the same two bodies that meet have is added up before
/// (MeetingForces). All is in the lists when it is destroyed; D and all else outlive it.
class Attachments::Forces {
 public:
  Forces(const Attachments& moves, const Increment& d, Arms arms, std::span<std::vector<BlockForce>> lists)
      : moves_(moves), d_(d), arms_(arms), lists_(lists) {}
  Forces(const Forces&) = delete;
  Forces& operator=(const Forces&) = delete;
  ~Forces() { finish_pair(); }
  /// As add_force.
  void add(int point, std::size_t kind, const Vec3& force);

 private:
  void finish_pair();

  const Attachments& moves_;
  const Increment& d_;
  const Arms arms_;
  std::span<std::vector<BlockForce>> lists_;
  int pair_ = -1;  // that is added up; −1: none
  std::array<MeetingForces, 3> of_pair_;
};

/// The derivative of forces at points that meet, one after the other, added up for each pair of bodies (PairTangent).
/// All is in the list when it is destroyed; D and all else outlive it.
class Attachments::PairSums {
 public:
  PairSums(const Attachments& moves, const Increment& d, bool with_unsymmetric, std::vector<PairSum>& list)
      : moves_(moves), d_(d), with_unsymmetric_(with_unsymmetric), list_(list) {}
  PairSums(const PairSums&) = delete;
  PairSums& operator=(const PairSums&) = delete;
  ~PairSums() { finish_pair(); }
  void add(int point, const PointTangent& at);

 private:
  void finish_pair();

  const Attachments& moves_;
  const Increment& d_;
  const bool with_unsymmetric_;
  std::vector<PairSum>& list_;
  int first_ = -1;  // point of the pair that is added up; −1: none
  PairTangent pair_;
};

/// Adds the derivative of forces at points, one after the other [N/m]: the part of springs to `symmetric`, what is
/// beside it to `unsymmetric`; null: it is not asked for. All is in the sums when it is destroyed; D and all else
/// outlive it.
class Attachments::Tangent {
 public:
  Tangent(const Attachments& moves, const Increment& d, Arms arms, SymmetricBlocks* symmetric,
          UnsymmetricBlocks* unsymmetric)
      : moves_(moves), d_(d), arms_(arms), symmetric_(symmetric), unsymmetric_(unsymmetric) {}
  Tangent(const Tangent&) = delete;
  Tangent& operator=(const Tangent&) = delete;
  ~Tangent() {
    pairs_.reset();
    moves_.add(list_, symmetric_, unsymmetric_);
  }
  void add(int point, const PointTangent& at) {
    if (moves_.meets(point))
      pairs_->add(point, at);
    else
      moves_.add_tangent(point, d_, arms_, at, symmetric_, unsymmetric_);
  }

 private:
  const Attachments& moves_;
  const Increment& d_;
  const Arms arms_;
  SymmetricBlocks* symmetric_;
  UnsymmetricBlocks* unsymmetric_;
  std::vector<PairSum> list_;
  std::optional<PairSums> pairs_{std::in_place, moves_, d_, unsymmetric_ != nullptr, list_};
};

}  // namespace talus
