#pragma once

#include "contact/contact_law.hpp"
#include "effects/contact_effect.hpp"
#include "effects/held_contact.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Springs against penetration, paper (29)–(31): with d_n = −(gap + n·u)
///   Π = Σ ½ k_n d_n²  where d_n > 0  [J]
/// and of points that a bond holds also in tension up to its strength, and no further. Points with and without a bond
/// are two effects: where no joint bonds, the second is absent.
class NormalContact final : public ContactEffect {
 public:
  enum class Points { loose, bonded };

  NormalContact(const ContactLinks& links, Points points, const EffectTolerances& tolerances = {})
      : ContactEffect(links, points == Points::bonded ? links.contacts().bonded : links.contacts().loose),
        tolerances_(tolerances),
        bonded_(points == Points::bonded) {}
  EffectKind kind() const override { return bonded_ ? EffectKind::cohesion_and_tension : EffectKind::normal_contact; }
  double energy(const Increment& d) const override;
  Vec3 force(int point, const Vec3& u) const override;
  void add_tangent(int point, const Vec3& u, PointTangent& sum) const override;
  /// Until it is told null, points are as these say, one a point of the contact set: then Π is quadratic in D.
  void hold(const std::vector<HeldContact>* held) { held_ = held; }
  /// Joins the bodies of points that may push while each degree-of-freedom block goes on from D by a fraction of its
  /// own, 0 to 1, of `change`. Those of each body are together.
  void join_touching(const Increment& d, const Eigen::VectorXd& change, DisjointSets& together) const;
  void accept(const Increment& d) override;
  void archive(StateArchive& state) override { state(stored_); }
  double stored_energy() const override { return stored_; }

 private:
  double force_at_gap(int point, double gap) const;  ///< N, compression positive
  bool has_spring(int point, double gap) const;

  EffectTolerances tolerances_;
  bool bonded_;
  const std::vector<HeldContact>* held_ = nullptr;
  double stored_ = 0;  ///< J, in the springs at the end of the last step
};

}  // namespace talus
