#include "verification/verify_random.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "verification/random_scenes_page.hpp"
#include "verification/verify_random_json.hpp"

namespace talus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::json;

std::vector<std::string> names_of(const RandomChoice& choice) {
  std::vector<std::string> names;
  for (const RandomSceneName& name : random_scene_names(choice)) names.push_back(to_string(name));
  return names;
}

TEST(VerifyRandom, FamiliesTakeTurns) {
  EXPECT_THAT(names_of({5, 17, {"drops", "impacts"}, {}}),
              ElementsAre("drops:17:1", "impacts:17:1", "drops:17:2", "impacts:17:2", "drops:17:3"));
  EXPECT_THAT(names_of({1, 3, {"drops"}, RandomBodies::mixed}), ElementsAre("drops:3:1:mixed"));
  const auto all = static_cast<int>(random_families().size());
  EXPECT_EQ(names_of({all + 1, 1, {}, {}}).back(), std::string(random_families()[0].name) + ":1:2");
  EXPECT_THROW(names_of({1, 1, {"geese"}, {}}), InputError);
}

TEST(VerifyRandom, RunsEachAndHandsItOn) {
  std::vector<std::string> ended;
  NoProgress progress;
  verify_random(random_scene_names({2, 1, {"drops"}, RandomBodies::rigid}), {}, progress,
                [&](const HardCase& scene, const Trial& trial) {
                  EXPECT_EQ(scene.name, trial.name);
                  EXPECT_EQ(trial.group, "drops");
                  EXPECT_GT(trial.steps, 0);
                  ended.push_back(trial.name);
                });
  EXPECT_THAT(ended, ElementsAre("drops:1:1:rigid", "drops:1:2:rigid"));
}

Trial trial_of(const std::string& family, const std::vector<Fault>& unmet, bool grows = false) {
  Trial trial;
  trial.name = family + ":1:1";
  trial.group = family;
  trial.title = "a title";
  trial.seconds = 2;
  trial.unmet = unmet;
  trial.grows = grows;
  return trial;
}

const std::vector<Trial> trials{trial_of("drops", {}), trial_of("impacts", {{FaultKind::lost, "it is behind"}}),
                                trial_of("drops", {{FaultKind::lost, "low"}, {FaultKind::lost, "lower"}}, true)};

TEST(VerifyRandom, CountsScenesByFamilyAndKindOfFault) {
  const std::vector<FamilyResult> results = family_results(trials);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].family, "drops");
  EXPECT_EQ(results[0].scenes, 2);
  EXPECT_EQ(results[0].held, 1);
  EXPECT_EQ(results[0].seconds, 4);
  EXPECT_EQ(faults_text(results[0]), "energy 1, lost 1") << "a scene counts once for a kind";
  EXPECT_EQ(faults_text(results[1]), "lost 1");
}

TEST(VerifyRandom, PageHasARowAFamilyAndWhatDoesNotHold) {
  const std::string page = random_scenes_page(trials);
  EXPECT_THAT(page, HasSubstr("1 of 3 scenes passed"));
  EXPECT_THAT(page, HasSubstr("| 2 | 1 | energy 1, lost 1 |"));
  EXPECT_THAT(page, HasSubstr("- **impacts:1:1** (a title): it is behind"));
}

TEST(VerifyRandom, JsonHasFamiliesBeforeScenes) {
  const Json json = Json::parse(random_json_text(trials));
  EXPECT_FALSE(json["passed"]);
  EXPECT_EQ(json["families"][0]["faults"]["energy"], 1);
  EXPECT_EQ(json["families"][1]["held"], 0);
  EXPECT_EQ(json["scenes"][1]["faults"][0], "it is behind");
  EXPECT_EQ(Json::parse(family_list_json())["families"].size(), random_families().size());
}

}  // namespace
}  // namespace talus
