#pragma once

#include "contact/contact_law.hpp"
#include "contact/contact_links.hpp"
#include "effects/effect.hpp"
#include "effects/held_contact.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Springs against penetration, paper (29)–(31): with d_n = −(gap + n·u)
///   Π = Σ ½ k_n d_n²  where d_n > 0  [J]
/// and of points that a bond holds also in tension up to its strength, and no further. Points with and without a bond
/// are two effects: where no joint bonds, the second is absent.
class NormalContact final : public Effect {
 public:
  enum class Points { loose, bonded };

  NormalContact(const ContactLinks& links, Points points, const EffectTolerances& tolerances = {})
      : links_(links),
        tolerances_(tolerances),
        bonded_(points == Points::bonded),
        all_(bonded_ ? links.contacts().bonded : links.contacts().loose) {}
  EffectKind kind() const override { return bonded_ ? EffectKind::cohesion_and_tension : EffectKind::normal_contact; }
  EnergyAccount account() const override { return EnergyAccount::contact; }
  bool quadratic() const override { return false; }
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const override;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const override;
  void add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const override;
  /// The Hessian takes contacts that are open by less than this fraction of their size for closed.
  void count_as_closed(double fraction) { touching_ = fraction; }
  /// Until it is told null, points are as these say, one a point of the contact set: then Π is quadratic in D.
  void hold(const std::vector<HeldContact>* held) { held_ = held; }
  /// Until it is told null, its points are these alone.
  void look_at(const std::vector<int>* points) { points_ = points ? points : &all_; }
  const std::vector<int>& all_points() const { return all_; }
  /// Joins the degree-of-freedom blocks of points that may push while each of these goes on from D by a fraction of its
  /// own, 0 to 1, of `change`.
  void join_touching(const Increment& d, const Eigen::VectorXd& change, DisjointSets& together) const;
  void accept(const Increment& d) override;
  void archive(StateArchive& state) override { state(stored_); }
  double stored_energy() const override { return stored_; }
  double work_on_held(const Increment& d) const override;

 private:
  double force(int point, double gap) const;  ///< N, compression positive
  bool has_spring(int point, double gap) const;

  const ContactLinks& links_;
  EffectTolerances tolerances_;
  bool bonded_;
  const std::vector<int>& all_;
  const std::vector<int>* points_ = &all_;
  double touching_ = 0;
  const std::vector<HeldContact>* held_ = nullptr;
  double stored_ = 0;  ///< J, in the springs at the end of the last step
};

}  // namespace talus
