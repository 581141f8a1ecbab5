#include "contact/body_width.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "mesh/surface.hpp"

namespace talus {

double least_width(const ContactBody& body, std::span<const Vec3> x) {
  const std::span<const Vec3> nodes = x.subspan(body.first_node, body.surface->ring.size());
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : nodes) sum += p - nodes[0];
  const Vec3 centre = nodes[0] + sum / static_cast<double>(nodes.size());
  Mat3 spread = Mat3::Zero();
  for (const Vec3& p : nodes) spread += (p - centre) * (p - centre).transpose();
  const Vec3 axis = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(0);
  double lower = 0, upper = 0;
  for (const Vec3& p : nodes) {
    const double along = axis.dot(p - centre);
    lower = std::min(lower, along);
    upper = std::max(upper, along);
  }
  return upper - lower;
}

}  // namespace talus
