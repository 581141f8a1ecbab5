#pragma once

#include "effects/contact_law.hpp"
#include "effects/contact_links.hpp"
#include "effects/effect.hpp"

namespace talus {

/// Springs against penetration, paper (29)–(31): with d_n = −(gap + n·u)
///   Π = Σ ½ k_n d_n²  where d_n > 0  [J]
/// and of points that a bond holds also in tension up to its strength, linear beyond. Points with and without a bond
/// are two effects: where no joint bonds, the other one is not there.
class NormalContact final : public Effect {
 public:
  enum class Points { loose, bonded };

  NormalContact(const ContactLinks& links, Points points)
      : links_(links),
        bonded_(points == Points::bonded),
        points_(bonded_ ? links.contacts().bonded : links.contacts().loose) {}
  std::string_view name() const override { return bonded_ ? "cohesion and tension" : "normal contact"; }
  EnergyAccount account() const override { return EnergyAccount::contact; }
  bool quadratic() const override { return false; }
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Eigen::VectorXd& sum) const override;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const override;
  void add_unsymmetric(const Increment& d, UnsymmetricBlocks& sum) const override;
  /// The Hessian takes contacts that are open by less than this share of their size for closed.
  void count_as_closed(double share) { touching_ = share; }
  /// Joins the freedoms of points that may push while each freedom goes its own share, 0 to 1, of `step` on from D.
  void join_meeting(const Increment& d, const Eigen::VectorXd& step, DisjointSets& together) const;
  void accept(const Increment& d) override;
  double stored_energy() const override { return stored_; }
  double work_on_held(const Increment& d) const override;

 private:
  const ContactLinks& links_;
  bool bonded_;
  const std::vector<int>& points_;
  double touching_ = 0;
  double stored_ = 0;  ///< J, in the springs at the end of the last step
};

}  // namespace talus
