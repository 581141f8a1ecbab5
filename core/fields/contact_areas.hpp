#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "results/frame.hpp"

namespace talus {

/// What is told of a joint at a place where two blocks touch, SI.
struct JointTraction {
  double normal = 0;                        ///< Pa, compression positive
  double shear = 0;                         ///< Pa
  double strength = 0;                      ///< Pa, of shear that the joint could bear there: c + σ tan φ
  double cohesion = 0;                      ///< Pa, of bonds that are whole
  ContactState state = ContactState::open;  ///< of the nearest contact point
  Bond bond = Bond::none;                   ///< likewise
};

/// Where two blocks touch in a frame: the contact points of a pair of blocks that lie in about one plane, and the
/// convex hull of those that have an area. Values within it are the sums of the points' forces over the sum of their
/// areas, both weighted by the inverse square of the distance: at a point those of that point alone, far from all of
/// them the mean. Points without an area of their own (where a vertex or an edge touches) count for nothing.
class ContactArea {
 public:
  /// At a place of the surface of one of the two blocks [m], with its outward unit normal; empty outside the hull, and
  /// where the plane is another one.
  std::optional<JointTraction> at(const Vec3& place, const Vec3& outward, int block) const;

 private:
  friend class ContactAreas;
  using Vec2 = Eigen::Vector2d;
  struct Point {
    Vec2 at;
    const ContactSample* contact;
  };
  Vec2 flat(const Vec3& place) const;
  void close();

  std::array<int, 2> blocks_{};
  double near_ = 0;  // m, from plane and hull: what lies so far off still belongs to it
  Vec3 origin_ = Vec3::Zero(), normal_ = Vec3::UnitZ(), x_ = Vec3::UnitX(), y_ = Vec3::UnitY();
  std::vector<Point> points_;
  std::vector<Vec2> hull_;  // counter-clockwise
};

/// All of a frame. Keeps pointers into the frame's contacts.
class ContactAreas {
 public:
  /// `sizes`: of the blocks, m.
  ContactAreas(std::span<const double> sizes, const Frame& frame);

  /// What is told at a place of a block's surface in this frame; empty where it touches nothing.
  std::optional<JointTraction> at(const Vec3& place, const Vec3& outward, int block) const;
  /// Whether a block touches anything.
  bool touches(int block) const { return !of_block_[static_cast<std::size_t>(block)].empty(); }

 private:
  void add(const ContactSample& contact);
  std::span<const double> sizes_;
  std::vector<ContactArea> areas_;
  std::vector<std::vector<int>> of_block_;
};

}  // namespace talus
