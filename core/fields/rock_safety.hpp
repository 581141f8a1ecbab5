#pragma once

#include "base/vector.hpp"
#include "model/project.hpp"

namespace talus {

/// The factor by which cohesion and tan φ may both be divided until Mohr's circle touches Coulomb's line, which is also
/// the least ratio of shear strength to shear stress of any plane: with principal stresses σ₁ ≥ σ₃, compression
/// positive, F = 2 √((c + σ₁ tan φ)(c + σ₃ tan φ)) / (σ₁ − σ₃). Where the rock is pulled, F is at most tensile strength
/// over largest tension; without a tensile strength that of the line's apex, c / tan φ, holds. 0 where the strength is
/// exceeded by pulling alone; no more than `most_safety`. Follows from Mohr's circle (Jaeger, Cook & Zimmerman,
/// Fundamentals of Rock Mechanics, 2007, chapter 4); the reduction of both is Zienkiewicz, Humpheson & Lewis,
/// Géotechnique 25 (1975) 671. `stress` [Pa], tension positive.
double rock_safety(const Voigt& stress, const RockStrength& strength);

/// What stands for all that is safer: of rock without stress it is infinite.
constexpr double most_safety = 10;

}  // namespace talus
