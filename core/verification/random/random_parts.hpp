#pragma once

#include <string>

#include "verification/hard_cases/elsewhere.hpp"
#include "verification/hard_cases/hard_case.hpp"
#include "verification/random/random_scene.hpp"

/// What families are made of: shapes, settings and places.
namespace talus {

/// A closed body about its own centroid.
struct RandomShape {
  std::string word;  ///< "sliver"
  TetMesh mesh;
  double thickness = 0;  ///< m, the least extent of any of its parts
  double radius = 0;     ///< m: no node is farther from the centroid
};

/// A cube, a box, a plate, a rod, a roof, a sliver, a tetrahedron, an octahedron, a prism; `hollowed` also a cross,
/// an L, a T, a U or a jack. Lengths are 1 to 10 times the thickness.
RandomShape random_shape(SceneNumbers& numbers, double thickness, bool hollowed);

/// What grips or gets caught, of thickness 1: a hook, a ring, a wedge with a sharp edge, a sliver, a plate.
RandomShape random_gripping_shape(SceneNumbers& numbers);

/// The shape as a block of the scene: turned, moved, and, where it deforms, more finely meshed by chance.
void add_random_block(CaseScene& scene, const std::string& name, const RandomShape& shape, BodyKind body,
                      const Mat3& turn, const Vec3& centroid, SceneNumbers& numbers, int material = 0);

/// Rock of any stiffness, and a joint of that friction angle [degrees].
CaseScene random_rock_scene(SceneNumbers& numbers, double friction_angle);

/// Solver settings that may change figures but not what holds: contact stiffness within a factor of 3, adaptive steps,
/// the tolerance of reference.
void draw_settings(SceneNumbers& numbers, SolverSettings& settings);

/// At the origin, on a site's own grid, or on a country's; turned about the vertical.
struct Site {
  explicit Site(SceneNumbers& numbers);
  Mat3 turn() const;
  std::string words() const;  ///< "azimuth 12°, 5e+06 m from the origin"

  double azimuth;             ///< degrees
  Vec3 shift = Vec3::Zero();  ///< m
};

/// Static steps until nothing moves any more, 200 at most.
Stage settling_stage(double time_step);

}  // namespace talus
