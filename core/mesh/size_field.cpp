#include "mesh/size_field.hpp"

#include <algorithm>
#include <limits>

namespace talus {

double size_at(const Vec3& point, double own, std::span<const MeshRefinement> refinements) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const MeshRefinement& refinement : refinements) {
    const double beyond = ((point - refinement.at).norm() - refinement.radius) / refinement.radius;
    if (beyond < 1) smallest = std::min(smallest, refinement.size + std::max(0.0, beyond) * (own - refinement.size));
  }
  return smallest < std::numeric_limits<double>::infinity() ? smallest : own;
}

double largest_size(double own, std::span<const MeshRefinement> refinements) {
  double largest = own;
  for (const MeshRefinement& refinement : refinements) largest = std::max(largest, refinement.size);
  return largest;
}

}  // namespace talus
