#include "mesh/moments.hpp"

#include <Eigen/LU>

namespace talus {

VolumeMoments volume_moments(const TetMesh& mesh) {
  VolumeMoments moments;
  if (mesh.tetrahedra.empty()) return moments;
  const Vec3& origin = mesh.nodes.front();  // near the block: coordinates may be those of a country's grid
  for (const auto& nodes : mesh.tetrahedra) {
    Mat3 edges;
    for (int i = 0; i < 3; ++i) edges.col(i) = mesh.nodes[nodes[i + 1]] - mesh.nodes[nodes[0]];
    const double volume = edges.determinant() / 6;
    Vec3 sum = Vec3::Zero();
    for (const int node : nodes) {
      const Vec3 x = mesh.nodes[node] - origin;
      moments.spread += volume / 20 * x * x.transpose();
      sum += x;
    }
    moments.centroid += volume / 4 * sum;
    moments.spread += volume / 20 * sum * sum.transpose();
    moments.volume += volume;
  }
  moments.centroid /= moments.volume;
  moments.spread = (moments.spread / moments.volume - moments.centroid * moments.centroid.transpose()).eval();
  moments.centroid += origin;
  return moments;
}

}  // namespace talus
