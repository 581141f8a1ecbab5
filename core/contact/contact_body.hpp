#pragma once

namespace talus {

struct Surface;

/// One body as contact sees it.
struct ContactBody {
  const Surface* surface = nullptr;  ///< outlives the detector; its node numbers are local
  int first_node = 0;                ///< local node i is global node first_node + i
  bool fixed = false;
  double young = 0;          ///< Pa
  bool single_body = false;  ///< rigid or affine: all its nodes move together
  bool deforms = false;      ///< affine or meshed, and not fixed
};

}  // namespace talus
