#pragma once

namespace talus {

/// A plate under axial load with a joint at 45° across it, part of which slips: Brady, Cramer & Hart (1985) on Olsson's
/// (1982) three slopes. Rock and joint are springs in series, 1/k = H/(WE) + cos²α/(KL) + sin²α/(KL) with L = W/cos α;
/// the joint slips against friction beside the spring K (L − ℓ) of what does not slip. Stiffnesses for 1 m of
/// thickness.
struct SlippingJoint {
  double height = 0, width = 0;  ///< m
  double young = 0;              ///< Pa
  double stiffness = 0;          ///< Pa/m, normal and shear
  double friction_angle = 0;     ///< degrees
  double slipping_length = 0;    ///< m, ℓ, from tip to tip

  double first_unloading() const;  ///< N/m, nothing slips
  double loading() const;          ///< N/m, shear is carried by friction and spring
  double last_unloading() const;   ///< N/m, friction acts against the spring

 private:
  /// N/m with slip forward (−1, friction helps) or back (+1).
  double with_slip(int direction) const;
};

}  // namespace talus
