#include "verification/verify_hard_cases.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/error.hpp"
#include "verification/verify_hard_cases_json.hpp"

namespace talus {
namespace {

using testing::ElementsAre;
using Json = nlohmann::json;

HardCase scene(const std::string& name, const std::string& group, bool takes_long = false) {
  HardCase one;
  one.name = name;
  one.group = group;
  one.title = "Title of " + name;
  one.takes_long = takes_long;
  one.build = []() -> CaseScene { throw std::runtime_error("no mesh"); };
  return one;
}

const std::vector<HardCase> scenes{scene("spike", "shapes"), scene("column", "crowds", true), scene("wall", "crowds")};

std::vector<std::string> chosen(const std::vector<std::string>& names, bool all, const std::string& group = {}) {
  std::vector<std::string> found;
  for (const HardCase& one : chosen_hard_cases(scenes, names, all, group)) found.push_back(one.name);
  return found;
}

TEST(VerifyHardCases, RunsWhatIsNamedOrAllThatIsQuickOrAGroup) {
  EXPECT_THAT(chosen({}, false), ElementsAre("spike", "wall"));
  EXPECT_THAT(chosen({}, true), ElementsAre("spike", "column", "wall"));
  EXPECT_THAT(chosen({"wall", "column"}, false), ElementsAre("wall", "column"));
  EXPECT_THAT(chosen({}, false, "crowds"), ElementsAre("wall"));
  EXPECT_THAT(chosen({}, true, "crowds"), ElementsAre("column", "wall"));
  EXPECT_THROW(chosen({"arch"}, true), InputError);
  EXPECT_THROW(chosen({}, true, "arches"), InputError);
}

TEST(VerifyHardCases, HandsEachTrialOnAndGoesOnAfterOneThatFails) {
  std::vector<std::string> ended;
  NoProgress progress;
  verify_hard_cases(scenes, {}, progress, [&](const Trial& trial) {
    EXPECT_FALSE(trial.passed());
    ended.push_back(trial.name + ": " + trial.reason);
  });
  EXPECT_THAT(ended, ElementsAre("spike: no mesh", "column: no mesh", "wall: no mesh"));
}

TEST(VerifyHardCases, JsonHasFiguresFaultsAndRepetitions) {
  Trial trial;
  trial.name = "spike";
  trial.group = "shapes";
  trial.steps = 4;
  trial.iterations = 10;
  trial.penetration = 2e-3;
  trial.repetitions = {{1, ""}, {2, "it ended otherwise"}};
  const Json json = Json::parse(json_text(std::vector<Trial>{trial}));
  EXPECT_FALSE(json["passed"]);
  const Json& one = json["scenes"][0];
  EXPECT_EQ(one["scene"], "spike");
  EXPECT_EQ(one["status"], "completed");
  EXPECT_EQ(one["iterations_per_step"], 2.5);
  EXPECT_EQ(one["faults"].size(), 2U);
  EXPECT_EQ(one["fingerprint"], "cbf29ce484222325") << "that of no snapshots, FNV-1a's offset";
  EXPECT_TRUE(one["repetitions"][0]["same_bits"]);
  EXPECT_FALSE(one["repetitions"][1]["same_bits"]);
  trial.penetration = 0;
  trial.repetitions.clear();
  EXPECT_TRUE(Json::parse(json_text(std::vector<Trial>{trial}))["passed"]);
  EXPECT_FALSE(Json::parse(json_text(std::vector<Trial>{trial}, false))["passed"]) << "not all were run";
  EXPECT_EQ(Json::parse(list_json(scenes))["scenes"][1]["takes_long"], true);
}

}  // namespace
}  // namespace talus
