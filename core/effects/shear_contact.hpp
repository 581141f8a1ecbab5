#pragma once

#include "contact/contact_law.hpp"
#include "effects/contact_effect.hpp"
#include "effects/held_contact.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Shear springs and friction, paper (32)–(40), as one potential. With the spring force τ* = τ₀ − k_s u_t, the relative
/// displacement u_t in the contact plane, and the strength F = c·A + F_n tan φ at the normal force of this iterate:
///   stick, |τ*| < F:  Π = |τ*|² / 2k_s                 [J]   paper (34)
///   slip:             Π = F|τ*| / k_s − F² / 2k_s       [J]   paper (37) but for terms of second order
/// Both meet with the same force: sliding needs no state of its own to be told from sticking. The gradient in slip is
/// the paper's friction force F against the direction of sliding; its Hessian keeps that direction from flipping
/// between iterations where the paper takes it from the previous displacement. That the strength follows the normal
/// force has no potential: its part of the tangent, tan φ k_n s⊗n, is what add_unsymmetric gives, beside the
/// turning of arms.
class ShearContact final : public ContactEffect {
 public:
  /// Looks at the points that resist shear alone.
  explicit ShearContact(const ContactLinks& links, const EffectTolerances& tolerances = {})
      : ContactEffect(links, links.contacts().sheared), tolerances_(tolerances) {}
  EffectKind kind() const override { return EffectKind::shear_contact; }
  double energy(const Increment& d) const override;
  /// Takes the strength from the normal force, paper (36).
  void follow(int point, const Vec3& u) override;
  /// At the strength that was taken last.
  Vec3 force(int point, const Vec3& u) const override;
  /// Points that count as closed count as sticking.
  void add_tangent(int point, const Vec3& u, PointTangent& sum) const override;
  /// Until `stick` is called, the tangent takes points for sliding that slid at the end of the last step and are above
  /// their strength at `d`, although they are on the border of sticking. True if there are any.
  bool let_slide(const Increment& d);
  void stick() { slides_on_.clear(); }
  /// Until it is told null, points are as these say, one a point of the contact set: then Π is quadratic in D.
  void hold(const std::vector<HeldContact>* held) { held_ = held; }
  /// What the law makes of a point at D, whose strength is known.
  ContactMode mode(int point, const Increment& d) const;
  void accept(const Increment& d) override;
  void archive(StateArchive& state) override { state(strength_, slides_on_, stored_); }
  double stored_energy() const override { return stored_; }
  double dissipated(const Increment& d) const override;

  /// Every point that it looks at follows from now on; those of others are zero.
  void clear_strength() { strength_.assign(links_.contacts().points.size(), 0); }
  /// Takes the strength of every point from the normal forces at D.
  void update_strength(const Increment& d);
  /// Joins the bodies of points with a strength: while strengths are held, one that has opened since shears on.
  void join_with_strength(DisjointSets& together) const;
  /// Force on the first body that the spring would bear if the contact could not slide, τ* [N].
  Vec3 spring_force(int point, const Increment& d) const {
    return spring_force_at(point, links_.moves().increment(point, d));
  }
  /// Shear force on the first body at D [N].
  Vec3 force_at(int point, const Increment& d) const { return force(point, links_.moves().increment(point, d)); }
  /// Length slipped in the step at D [m], the excess of the spring's force over its stiffness; 0 where that is within
  /// the rounding of coordinates.
  double slip(int point, const Increment& d) const;
  double strength(int point) const { return strength_[point]; }

 private:
  Vec3 spring_force_at(int point, const Vec3& u) const;
  bool slides(int point, double spring_force) const {
    if (held_) return (*held_)[point].shear == ContactMode::slip;
    return spring_force > strength_[point] || (!slides_on_.empty() && slides_on_[point]);
  }
  /// Force across the held friction of a point that slides: what friction gains as it turns with the sliding [N].
  Vec3 turned(int point, const Vec3& spring_force) const;
  /// Of a point that bears shear.
  Vec3 force_of(int point, const Vec3& spring_force) const;
  /// By how much the force falls as the point moves, in stick or in slip, its strength held [N/m].
  Mat3 spring_at(int point, const Vec3& spring_force) const;

  /// Whether a point bears no shear.
  bool is_free(int point) const { return held_ ? (*held_)[point].shear == ContactMode::open : strength_[point] == 0; }

  EffectTolerances tolerances_;
  std::vector<double> strength_;  ///< N, a point of the contact set; zero where it does not resist shear
  std::vector<bool> slides_on_;   ///< a point of the contact set; empty: none
  const std::vector<HeldContact>* held_ = nullptr;
  double stored_ = 0;  ///< J, in the springs at the end of the last step
};

}  // namespace talus
