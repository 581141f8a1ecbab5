#pragma once

#include "base/vector.hpp"

/// The Lorentz cone v₀ ≥ |(v₁, v₂)| and its Jordan algebra (Alizadeh & Goldfarb 2003): Coulomb's cone with a
/// coefficient of friction of 1. All vectors must lie inside of it.
namespace talus::lorentz_cone {

/// v₀² − v₁² − v₂².
double determinant(const Vec3& v);
/// The w of which v∘w = (1, 0, 0).
Vec3 inverse(const Vec3& v);
/// Jordan product v∘w = (v·w, v₀ w₁ + w₀ v₁, v₀ w₂ + w₀ v₂).
Vec3 product(const Vec3& v, const Vec3& w);
/// The w of which v∘w is the given product.
Vec3 quotient(const Vec3& product, const Vec3& v);
/// The fraction of `change` after which v leaves the cone; huge where it never does.
double fraction_inside(const Vec3& v, const Vec3& change);

/// The symmetric matrix W of Nesterov & Todd (1997) by which W z = W⁻¹ x =: λ, and its inverse.
struct Scaling {
  Mat3 matrix, inverse;
  Vec3 scaled;  ///< λ
  Scaling(const Vec3& x, const Vec3& z);
};

}  // namespace talus::lorentz_cone
