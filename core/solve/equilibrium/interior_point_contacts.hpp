#pragma once

#include <vector>

#include "contact/contact_links.hpp"
#include "linear/unsymmetric_blocks.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Loose contact points as the interior-point method sees them: each with a force r and a relative displacement y, both
/// strictly inside their cones. Their product r·y, the complementarity, vanishes in contact; the method brings it down
/// from iteration to iteration while D follows.
///
/// Coulomb's law as one relation (De Saxcé & Feng 1998): r = (F_n, τ) in the cone |τ| ≤ μ F_n, y = (y_n + μ|y_t|, y_t)
/// in its dual, r·y = 0. Springs of stiffness k_n, k_s make of it, with λ and τ₀ of the point,
///   y_n = gap + n·u + (F_n − λ)/k_n,   y_t = u_t + (τ − τ₀)/k_s  [m],
/// so that r is the force of NormalContact and ShearContact where r·y = 0. In x = (μ F_n, τ) [N] and
/// z = (y_n/μ + |y_t|, y_t) [m] both cones are the Lorentz cone, and Newton's method on x∘z = ε, scaled as Nesterov &
/// Todd do, condenses into one spring a point. A point without friction has x = F_n, z = y_n alone.
class InteriorPointContacts {
 public:
  explicit InteriorPointContacts(const InteriorPointTolerances& tolerances = {}) : tolerances_(tolerances) {}

  void clear() { points_.clear(); }
  /// Takes those of these points that may come to bear when without contacts the bodies would go on from D by `flight`
  /// [m], to `landed`, and push others on. All begin with one complementarity: the depth of the deepest, at D or there,
  /// times `force` [N], which is about what contacts may have to bear. The links must outlive what is asked of it from
  /// here on.
  void begin(const ContactLinks& links, const std::vector<int>& points, const Increment& d,
             const Eigen::VectorXd& flight, const Increment& landed, double force);
  /// The law's linearisation at D, which the next changes are found with.
  void linearise(const Increment& d);
  /// The next changes shall bring all complementarity to zero, to first order.
  void target_contact();
  /// The next changes shall bring it to this value [J] at each point, with a correction of second order from the
  /// changes found last.
  void target_complementarity(double complementarity);

  /// sum += Jᵀ of the forces, to first order, if D does not change [N].
  void add_forces(const Increment& d, Arms arms, Eigen::VectorXd& sum) const;
  /// The linearisation's derivative of these forces by D, Jᵀ(…)J [N/m], as if forces did not turn with the bodies: at
  /// first they are far larger than those to come, and what they turned would leave nothing of a direction.
  void add_tangent(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const;

  /// Changes of forces and displacements while D goes from `from` to `to`.
  void find_changes(const Increment& from, const Increment& to);
  /// The largest fraction of these changes, at most 1, after which all points are still inside their cones.
  double longest_step_fraction() const;
  void change_by(double fraction);
  /// Mean of r·y [J].
  double mean_complementarity() const;
  int size() const { return static_cast<int>(points_.size()); }

 private:
  struct Point {
    int index = 0;
    double friction = 1;             ///< that x and z are scaled with; 1 where there is none
    Mat3 directions = Mat3::Zero();  ///< columns: n/μ and two of the contact plane, zero without friction
    Vec3 compliance = Vec3::Zero();  ///< m/N, of z for x
    Vec3 initial = Vec3::Zero();     ///< m, y at D = 0 without force
    Vec3 x = Vec3::Zero(), z = Vec3::Zero();
    // The linearisation: along the directions
    //   Δx = first − tangent Δu,  Δz = displacement − z + dilation (compliance Δx + Δu).
    Vec3 displacement = Vec3::Zero();                                      ///< m, the z that belongs to x and D
    Mat3 dilation = Mat3::Zero();                                          ///< of z by y: slip opens the contact
    Mat3 response = Mat3::Zero();                                          ///< N/m, of x to z
    Mat3 tangent = Mat3::Zero();                                           ///< N/m, response·dilation
    Vec3 first = Vec3::Zero();                                             ///< N
    Vec3 force_change = Vec3::Zero(), displacement_change = Vec3::Zero();  ///< Δx, Δz
  };
  Point point_at(int index) const;
  /// The z that belongs to x and D [m].
  Vec3 displacement_of(const Point& point, const Increment& d) const;

  InteriorPointTolerances tolerances_;
  const ContactLinks* links_ = nullptr;
  std::vector<Point> points_;
};

}  // namespace talus
