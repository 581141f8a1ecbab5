#include "verification/random/random_scene.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/error.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

class EveryFamily : public testing::TestWithParam<std::string> {
 protected:
  static HardCase scene(std::uint64_t seed, std::uint64_t number, std::optional<RandomBodies> bodies = {}) {
    return random_scene({GetParam(), seed, number, bodies});
  }
};

/// All that there is of two scenes is the same, to the bit.
bool same(const CaseScene& a, const CaseScene& b) {
  return a.project == b.project &&
         std::equal(a.system.blocks.begin(), a.system.blocks.end(), b.system.blocks.begin(), b.system.blocks.end(),
                    [](const Block& one, const Block& other) {
                      return one.name == other.name && one.body == other.body && one.material == other.material &&
                             one.mesh.nodes == other.mesh.nodes && one.mesh.tetrahedra == other.mesh.tetrahedra;
                    });
}

TEST_P(EveryFamily, DrawsTheSameSceneFromTheSameNameAndAnotherFromAnother) {
  const CaseScene first = scene(7, 3).build();
  EXPECT_TRUE(same(first, scene(7, 3).build()));
  EXPECT_FALSE(same(first, scene(7, 4).build()));
  EXPECT_FALSE(same(first, scene(8, 3).build()));
}

TEST_P(EveryFamily, ScenesAreNamedTitledAndExpectSomething) {
  const HardCase drawn = scene(7, 3);
  EXPECT_EQ(drawn.name, GetParam() + ":7:3");
  EXPECT_EQ(drawn.group, GetParam());
  EXPECT_FALSE(drawn.title.empty());
  EXPECT_FALSE(drawn.expected.empty());
}

TEST_P(EveryFamily, ChosenBodiesChangeNothingElse) {
  for (const RandomBodies bodies : {RandomBodies::rigid, RandomBodies::affine}) {
    const HardCase drawn = scene(7, 3, bodies);
    EXPECT_EQ(drawn.name, GetParam() + ":7:3:" + std::string(to_string(bodies)));
    for (const Block& block : drawn.build().system.blocks)
      EXPECT_TRUE(block.body == BodyKind::fixed || to_string(block.body) == to_string(bodies)) << block.name;
  }
  EXPECT_EQ(scene(7, 3, RandomBodies::rigid).build().project.stages,
            scene(7, 3, RandomBodies::tetrahedra).build().project.stages);
}

TEST_P(EveryFamily, OtherSettingsChangeNothingButSettings) {
  const HardCase plain = scene(7, 3), other = random_scene({GetParam(), 7, 3, {}, true});
  EXPECT_EQ(other.name, GetParam() + ":7:3:settings");
  CaseScene before = plain.build(), after = other.build();
  EXPECT_NE(before.project.solver, after.project.solver);
  after.project.solver = before.project.solver;
  EXPECT_TRUE(same(before, after));
}

TEST_P(EveryFamily, ComesToTheSameElsewhereUnlessThereAreBlows) {
  const HardCase drawn = scene(7, 3);
  EXPECT_EQ(drawn.elsewhere.has_value(), !random_family(GetParam()).has_blows && !drawn.has_blows);
  EXPECT_NEAR(drawn.elsewhere.value_or(Elsewhere{0, {5e6, 0, 0}}).shift.norm(), 5e6, 1e-3);
}

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const RandomFamily& family : random_families()) names.emplace_back(family.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(RandomScenes, EveryFamily, testing::ValuesIn(family_names()),
                         [](const auto& family) { return family.param; });

TEST(RandomSceneName, IsReadAsItIsWritten) {
  for (const std::string text :
       {"impacts:17:42", "drops:18446744073709551615:1:mixed", "drops:1:2:settings", "drops:1:2:affine:settings"})
    EXPECT_EQ(to_string(random_scene_name_from(text)), text);
  EXPECT_EQ(random_scene_name_from("impacts:17:42:rigid"), (RandomSceneName{"impacts", 17, 42, RandomBodies::rigid}));
}

TEST(RandomSceneName, SaysWhatIsWrongWithIt) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      random_scene_name_from(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal("impacts"), HasSubstr("write it like impacts:17:42"));
  EXPECT_THAT(refusal("impacts:17:x"), HasSubstr("'x' is no whole number"));
  EXPECT_THAT(refusal("impacts:17:-1"), HasSubstr("'-1' is no whole number"));
  EXPECT_THAT(refusal("geese:17:1"), HasSubstr("choose among impacts, drops"));
  EXPECT_THAT(refusal("impacts:17:1:stone"), HasSubstr("choose among rigid, affine"));
}

}  // namespace
}  // namespace talus
