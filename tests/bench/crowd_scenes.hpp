#pragma once

#include <string>

#include "verification/known_answers/support/scene.hpp"

namespace talus {

/// Many blocks, little else.
///   pile   N × N × N unit cubes on each other on a slab: all rest
///   slide  N × N × N unit cubes side by side on a slope of 20°, friction below it: all slide
///   pour   N pebbles (boxes, prisms, octahedra, tetrahedra, turned and stretched at random) fall into a pit
///   slope  a bench above a bedding plane of 25° to 45°, cut by that plane's set and two more of random attitude, N
///          planes a set: about N² blocks for N = 5 … 9, more than a thousand for N = 30; slides
///   stand  the same with friction 10° above the dip of the bedding: hardly moves
enum class CrowdKind { pile, slide, pour, slope, stand };

struct Crowd {
  CrowdKind kind = CrowdKind::pile;
  int n = 10;  ///< as above
  int seed = 1;
  BodyKind body = BodyKind::rigid;
  double time_step = 0.01;  ///< s, of one dynamic stage
  int steps = 20;
  bool sleeps = false;  ///< blocks at rest may sleep
  int cells = 0;  ///< of a pile of tetrahedra: along an edge of a cube, of six tetrahedra each; 0: as few as can be
};

/// "slope 12, affine".
std::string name_of(const Crowd& crowd);

/// A project of it, solids and cuts; one seed gives one scene on every machine.
Project project_of(const Crowd& crowd);

/// The same with its blocks: meshed in the program where nothing is cut, since touching polyhedra take gmsh long, else
/// by the mesher.
CaseScene scene_of(const Crowd& crowd);

}  // namespace talus
