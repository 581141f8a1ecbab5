#pragma once

#include "base/vector.hpp"

/// The Lorentz cone v₀ ≥ |(v₁, v₂)| and its algebra (Alizadeh & Goldfarb 2003): Coulomb's cone at a coefficient of one.
/// What follows asks for vectors inside of it.
namespace talus::lorentz_cone {

/// v₀² − v₁² − v₂².
double determinant(const Vec3& v);
/// The vector that v is multiplied with to give (1, 0, 0).
Vec3 inverse(const Vec3& v);
/// v∘w = (v·w, v₀ w₁ + w₀ v₁, v₀ w₂ + w₀ v₂).
Vec3 product(const Vec3& v, const Vec3& w);
/// The w of which v∘w is the given product.
Vec3 quotient(const Vec3& product, const Vec3& v);
/// The share of `change` at which v would leave the cone; huge where it never does.
double share_inside(const Vec3& v, const Vec3& change);

/// The symmetric matrix W of Nesterov & Todd (1997) by which W z = W⁻¹ x =: λ, and its inverse.
struct Scaling {
  Mat3 matrix, inverse;
  Vec3 scaled;  ///< λ
  Scaling(const Vec3& x, const Vec3& z);
};

}  // namespace talus::lorentz_cone
