#pragma once

#include <span>

#include "model/rock/blocks.hpp"

namespace talus {

/// The length that edges aim at wherever gmsh meshes while this lives.
class SizesInForce {
 public:
  /// `size`: m, but for where `refinements` say another; these must outlive this.
  SizesInForce(double size, std::span<const MeshRefinement> refinements);
  ~SizesInForce();
  SizesInForce(const SizesInForce&) = delete;
  SizesInForce& operator=(const SizesInForce&) = delete;
};

}  // namespace talus
