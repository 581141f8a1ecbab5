#pragma once

#include <array>
#include <span>
#include <string>

#include "verification/known_answers/wedges/wedge_in_mould.hpp"

/// The 65 physical tests of wedges on a tilting table: Yeung, Jiang & Sun (2003), and the coupled method of the paper
/// that Talus implements, Tables 1 and 2.
namespace talus {

/// A row of the tables, in the table's frame: z up, the table tilts about x. Directions are printed to 0.01.
struct WedgeTest {
  using Direction = std::array<double, 3>;

  int block;                       ///< 1 or 2
  double beta, alpha;              ///< degrees: orientation of the block on the table, tilt of the table
  Direction descent_1, descent_2;  ///< steepest descents of plane 1 and plane 2
  Direction line;                  ///< Direction 1 or 2, whichever leads down
  WedgeMode coupled;               ///< failure mode by the paper's coupled method
  Direction coupled_direction;     ///< of the centroid's displacement; zero where stable
  WedgeMode physical;              ///< failure mode of the plaster model

  std::string name() const;  ///< "B1-60-18.3"
  WedgeShape shape() const;
  /// From the wedge's frame to the table's. The table's plane 1 is the shape's.
  Mat3 turn() const;
  WedgeEquilibrium equilibrium() const;
};

/// All rows in the order of the tables.
std::span<const WedgeTest> wedge_tests();

/// Degrees: the mean of ten direct shear tests on the plaster.
inline constexpr double plaster_friction_angle = 32.5;
/// Density and elasticity of both blocks.
Material plaster();

}  // namespace talus
