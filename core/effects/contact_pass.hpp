#pragma once

#include <span>
#include <vector>

#include "effects/contact_effect.hpp"

namespace talus {

/// All laws of contact together: how a point has moved is found once for all of them. Points are looked at on several
/// cores, part by part, those of two bodies in one part; what comes of it is added up in their order, to the same bits
/// on any number of cores.
class ContactPass {
 public:
  /// All of the same links; they outlive it.
  void set(std::vector<ContactEffect*> effects);
  const std::vector<ContactEffect*>& effects() const { return effects_; }

  /// Adds the gradient of each effect to a sum of its own [N]. With `follow` each follows before where its points are.
  void add_gradients(const Increment& d, Arms arms, bool follow, std::span<Eigen::VectorXd> sums);
  /// Adds the derivative of the gradient: the part of springs, and what is beside it; null: it is not asked for [N/m].
  void add_tangents(const Increment& d, Arms arms, SymmetricBlocks& symmetric, UnsymmetricBlocks* unsymmetric);

 private:
  struct Part {
    int begin = 0, end = 0;  // points
    std::vector<std::vector<BlockForce>> forces;
    std::vector<Attachments::PairSum> pairs;
    bool all_meet = true;
  };
  const Attachments& moves() const;
  void divide();
  /// Calls find(part) for all parts, some at a time and these at once, and then add(these parts).
  template <class Find, class Add>
  void each_part(const Find& find, const Add& add);
  /// Adds what pairs of bodies that meet add to the tangent, column by column.
  void add_pairs(std::span<const Part> parts, SymmetricBlocks& symmetric, UnsymmetricBlocks* unsymmetric) const;
  /// Calls use(point, effects that act at it) for the points of a part in order.
  template <class Use>
  void each_point(const Part& part, const Use& use) const;

  std::vector<ContactEffect*> effects_;
  std::vector<int> boundaries_;  // of parts: points
  std::vector<Part> parts_;      // as many as are looked at at once
};

}  // namespace talus
