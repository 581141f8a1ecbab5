#pragma once

#include "base/vector.hpp"

namespace talus {

/// The nearest rotation R to a deformation gradient F: F = R S with S symmetric. For an inverted F (det ≤ 0) still a
/// proper rotation, with a negative stretch. (Higham 1986; singular values where F is singular or inverted.)
Mat3 rotation_of(const Mat3& deformation_gradient);

}  // namespace talus
