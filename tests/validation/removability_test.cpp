#include <gmock/gmock.h>

#include "removability/block_facts.hpp"
#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace talus {
namespace {

/// The wedge of each of the 65 tests as the table of blocks tells of it, from the faces of the blocks alone, beside
/// limit equilibrium on the planes that the tests were built from.
TEST(RemovabilityOfWedges, IsThatOfLimitEquilibriumInAll65Tests) {
  ASSERT_EQ(wedge_tests().size(), 65U);
  for (const WedgeTest& test : wedge_tests()) {
    SCOPED_TRACE(test.name());
    const CaseScene scene = wedge_test_scene(test, plaster_friction_angle, 0, 1);
    const auto wedge = std::find_if(scene.system.blocks.begin(), scene.system.blocks.end(),
                                    [](const Block& block) { return block.body != BodyKind::fixed; });
    ASSERT_NE(wedge, scene.system.blocks.end());
    const BlockFacts facts =
        block_facts(scene.project, scene.system)[static_cast<std::size_t>(wedge - scene.system.blocks.begin())];
    const WedgeEquilibrium known = test.equilibrium();

    const bool falls = known.kinematic == WedgeMode::free_fall;
    const bool on_line = known.kinematic == WedgeMode::line_1 || known.kinematic == WedgeMode::line_2;
    EXPECT_EQ(facts.leaving.leaving, falls     ? Leaving::falls
                                     : on_line ? Leaving::slides_on_two
                                               : Leaving::slides_on_one);
    const Vec3 down = scene.project.gravity.normalized();
    EXPECT_NEAR(facts.leaving.direction.dot(down), known.driving, 1e-9);
    ASSERT_TRUE(facts.leaving.factor);
    EXPECT_NEAR(*facts.leaving.factor, known.factor(plaster_friction_angle), 1e-9);
  }
}

}  // namespace
}  // namespace talus
