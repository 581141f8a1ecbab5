#include <gtest/gtest.h>

#include "mesh/surface.hpp"
#include "verification/hard_cases/interpenetration.hpp"
#include "verification/hard_cases/scenes/all_hard_cases.hpp"

namespace talus {
namespace {

/// What a scene does wrong is to be the solver's doing: its blocks are meshes without folds in closed surfaces, and
/// none begins in another. A few of the jointed slopes do for all of them: the mesher cuts them, and their trials
/// look for the same as they begin.
TEST(HardCaseScenes, AreMadeOfSolidBlocksApart) {
  for (const HardCase& scene : hard_cases()) {
    if (scene.group == "jointed slopes" && scene.takes_long) continue;
    SCOPED_TRACE(scene.name);
    const CaseScene built = scene.build();
    for (const Block& block : built.system.blocks) {
      for (const auto& tetrahedron : block.mesh.tetrahedra)
        ASSERT_GT(volume({block.mesh.nodes, {tetrahedron}}), 0) << block.name;
      ASSERT_NO_THROW(make_surface(block.mesh.nodes, block.surface)) << block.name;
    }
    const Interpenetration found =
        InterpenetrationCheck(built.system).deepest(Simulation(built.project, built.system).bodies());
    EXPECT_LT(found.depth, 1e-6) << found.block << " in " << found.into;
  }
}

}  // namespace
}  // namespace talus
