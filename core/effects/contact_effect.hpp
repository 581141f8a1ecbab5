#pragma once

#include "contact/contact_links.hpp"
#include "effects/effect.hpp"

namespace talus {

/// A law of contact: what it does at a point hangs on how that point alone has moved. How the bodies move the point,
/// and what forces there do to them, is found once for all laws together.
class ContactEffect : public Effect {
 public:
  /// `points`: those of the contact set that it acts at, ascending. Both outlive it.
  ContactEffect(const ContactLinks& links, const std::vector<int>& points) : links_(links), all_(points) {}
  EnergyAccount account() const final { return EnergyAccount::contact; }
  bool quadratic() const final { return false; }
  void look_at(const PickedBodies* picked) final { points_ = links_.points_of(picked, all_, picked_); }
  const ContactLinks& links() const { return links_; }
  /// Those that it looks at, ascending.
  const std::vector<int>& points() const { return *points_; }

  /// On the first body at a point that has moved by `u` against the second [N].
  virtual Vec3 force(int point, const Vec3& u) const = 0;
  /// Takes from how the point has moved what is held while forces are frozen.
  virtual void follow(int /*point*/, const Vec3& /*u*/) {}
  /// How the gradient, the other way than the force, changes there; points count as closed that count_as_closed says.
  virtual void add_tangent(int point, const Vec3& u, PointTangent& sum) const = 0;
  /// From now on the symmetric part of the tangent takes contacts that are open by less than this fraction of their
  /// size for closed.
  void count_as_closed(double fraction) { touching_ = fraction; }

  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const final;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const final;
  void add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const final;
  double work_on_held(const Increment& d) const final;

 protected:
  const ContactLinks& links_;
  double touching_ = 0;

 private:
  void add_tangents(const Increment& d, Arms arms, SymmetricBlocks* symmetric, UnsymmetricBlocks* unsymmetric) const;

  const std::vector<int>& all_;
  const std::vector<int>* points_ = &all_;
  std::vector<int> picked_;  ///< of the bodies that it looks at alone
};

}  // namespace talus
