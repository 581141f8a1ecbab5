#pragma once

#include <vector>

#include "effects/contact_links.hpp"
#include "effects/unsymmetric_blocks.hpp"

namespace talus {

/// Loose contact points as an interior method sees them: each with a force r and a way y that it keeps off contact,
/// both strictly inside their cones, whose product it brings down from step to step while D follows.
///
/// Coulomb's law as one relation (De Saxcé & Feng 1998): r = (F_n, τ) in the cone |τ| ≤ μ F_n, y = (y_n + μ|y_t|, y_t)
/// in its dual, r·y = 0. Springs of stiffness k_n, k_s make of it, with λ and τ₀ of the point,
///   y_n = gap + n·u + (F_n − λ)/k_n,   y_t = u_t + (τ − τ₀)/k_s  [m],
/// so that r is the force of NormalContact and ShearContact where r·y = 0. In x = (μ F_n, τ) [N] and
/// z = (y_n/μ + |y_t|, y_t) [m] both cones are the Lorentz cone, and Newton's method on x∘z = ε, scaled as Nesterov &
/// Todd do, condenses into one spring a point. A point without friction has x = F_n, z = y_n alone.
class InteriorContacts {
 public:
  void clear() { points_.clear(); }
  /// Takes the points that may come to bear when without contacts the bodies would go on from D by `flight` [m], and
  /// kick others on. All begin with one product, of the depth of the deepest times `force` [N], which counts as the
  /// force that contacts may have to bear. The links must outlive what is asked of it from here on.
  void begin(const ContactLinks& links, const Increment& d, const Eigen::VectorXd& flight, double force);
  /// The law's linearisation at D, which the next changes are found with.
  void linearise(const Increment& d);
  /// The next changes shall bring all products to zero, to first order.
  void aim_at_contact();
  /// The next changes shall bring them to `product` [J], with what the last changes found miss by in second order.
  void aim_at(double product);

  /// sum += Jᵀ of the forces that there are to first order when D does not change [N].
  void add_forces(const Increment& d, Eigen::VectorXd& sum) const;
  /// Jᵀ of what the linearisation makes of a change of D, all of it [N/m].
  void add_tangent(const Increment& d, UnsymmetricBlocks& sum) const;

  /// What forces and ways do while D goes on to `to`.
  void find_changes(const Increment& from, const Increment& to);
  /// The share of the changes, at most 1, by which all stay inside.
  double longest_share() const;
  void change_by(double share);
  /// Mean of r·y [J].
  double mean_product() const;
  int size() const { return static_cast<int>(points_.size()); }

 private:
  struct Point {
    int index = 0;
    double friction = 1;             ///< that x and z are scaled with; 1 where there is none
    Mat3 directions = Mat3::Zero();  ///< columns: n/μ and two of the contact plane, zero without friction
    Vec3 compliance = Vec3::Zero();  ///< m/N, of z for x
    Vec3 apart = Vec3::Zero();       ///< m, y that belongs to D = 0 and no force
    Vec3 x = Vec3::Zero(), z = Vec3::Zero();
    // The linearisation: along the directions
    //   Δx = first − tangent Δu,  Δz = way − z + lifting (compliance Δx + Δu).
    Vec3 way = Vec3::Zero();                                      ///< m, the z that belongs to x and D
    Mat3 lifting = Mat3::Zero();                                  ///< by which z follows y: sliding lifts
    Mat3 response = Mat3::Zero();                                 ///< N/m, by which x follows z
    Mat3 tangent = Mat3::Zero();                                  ///< N/m, response·lifting
    Vec3 first = Vec3::Zero();                                    ///< N
    Vec3 force_change = Vec3::Zero(), way_change = Vec3::Zero();  ///< Δx, Δz
  };
  Point point_at(int index) const;
  /// The z that belongs to x and D [m].
  Vec3 way_of(const Point& point, const Increment& d) const;

  const ContactLinks* links_ = nullptr;
  std::vector<Point> points_;
};

}  // namespace talus
