#pragma once

#include <Eigen/Core>

namespace talus {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Stress or engineering strain as the paper writes it, eq. (3): xx, yy, zz, xy, yz, zx.
using Voigt = Eigen::Matrix<double, 6, 1>;

}  // namespace talus
