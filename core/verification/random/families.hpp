#pragma once

#include "verification/random/random_scene.hpp"

/// What each family draws, a file each or one for a few that are akin.
namespace talus {

HardCase random_impact(Draw& draw);
HardCase random_drop(Draw& draw);
HardCase random_collision(Draw& draw);
HardCase random_incline(Draw& draw);
HardCase random_wedge(Draw& draw);
HardCase random_toppling(Draw& draw);
HardCase random_tower(Draw& draw);
HardCase random_slope(Draw& draw);
HardCase random_pour(Draw& draw);
HardCase random_chain(Draw& draw);
HardCase random_shaking(Draw& draw);
HardCase random_coincidence(Draw& draw);
HardCase random_ratios(Draw& draw);
HardCase random_voronoi_slope(Draw& draw);
HardCase random_arch(Draw& draw);
HardCase random_dominoes(Draw& draw);
HardCase random_cavern(Draw& draw);
HardCase random_terrain(Draw& draw);
HardCase random_tangle(Draw& draw);

}  // namespace talus
