#pragma once

#include "verification/known_answers/support/scene.hpp"

/// Scenes at another place: nature does not know where the origin of a survey's grid lies, nor where its north.
namespace talus {

/// Another place on earth.
struct Elsewhere {
  double azimuth = 0;         ///< degrees, by which all is turned about the vertical
  Vec3 shift = Vec3::Zero();  ///< m
};

/// The whole scene turned about the origin, gravity, velocities, loads and moving bases too, then moved. What is held
/// in some components of displacement alone, and what stages change of loads, is not turned.
void place_scene(CaseScene& scene, const Mat3& turn, const Vec3& shift);

/// The scene there, its coordinates rounded as they are there.
CaseScene moved_elsewhere(CaseScene scene, const Elsewhere& place);

/// The same shapes, rounded as they were elsewhere, with a corner of its first block at the origin and turned back:
/// what differs from `there` are place and azimuth alone. Coordinates 5e6 m from the origin are rounded to 1e-9 m,
/// which would make other scenes of small ones.
CaseScene brought_home(CaseScene there, const Elsewhere& place);

/// Diagonal of the box around all that moves [m].
double extent_of_what_moves(const CaseScene& scene);

/// The most that displacements of a block in both runs are apart [m], those at home turned as the scene was.
double most_apart(const std::vector<Vec3>& at_home, const std::vector<Vec3>& there, const Elsewhere& place);

}  // namespace talus
