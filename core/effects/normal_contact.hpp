#pragma once

#include "effects/contact_law.hpp"
#include "effects/effect.hpp"

namespace talus {

/// Springs against penetration, paper (29)–(31): with d_n = −(gap + n·u)
///   Π = Σ ½ k_n d_n²  where d_n > 0  [J]
/// and, where a bond holds, also in tension up to its strength, linear beyond.
class NormalContact final : public Effect {
 public:
  NormalContact(const BodySet& set, const ContactSet& contacts) : set_(set), contacts_(contacts) {}
  std::string_view name() const override { return "normal contact"; }
  EnergyAccount account() const override { return EnergyAccount::contact; }
  bool quadratic() const override { return false; }
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Eigen::VectorXd& sum) const override;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const override;
  /// The Hessian takes contacts that are open by less than this share of their size for closed.
  void count_as_closed(double share) { touching_ = share; }
  void accept(const Increment& d) override;
  double stored_energy() const override { return stored_; }
  double work_on_held(const Increment& d) const override;

 private:
  double gap(const ContactPoint& point, const Increment& d) const;
  const BodySet& set_;
  const ContactSet& contacts_;
  double touching_ = 0;
  double stored_ = 0;  ///< J, in the springs at the end of the last step
};

}  // namespace talus
