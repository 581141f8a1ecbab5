#pragma once

#include <Eigen/Geometry>
#include <span>

#include "geometry/mesher/acting_joints.hpp"
#include "geometry/mesher/shape_import.hpp"

namespace talus {

/// Into how many parts the joints divide a box. Planes in general position make one part more than there are planes
/// that meet it, lines of two planes and points of three (Schläfli 1852: of convex regions). Joints that end count
/// where they meet: what of them divides nothing makes the number too large. Of many joints some pairs and triples
/// speak for all, the same ones each time.
double parts_of_box(std::span<const ActingJoint> joints, const Eigen::AlignedBox3d& box);

/// What cutting all solids will come to, before it is done: solids are taken as the boxes around them.
MesherCutAhead cut_ahead(const MesherJob& job, const ImportedModel& model);

}  // namespace talus
