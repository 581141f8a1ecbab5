#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "process.hpp"

// What is known of a project before it is solved.
namespace talus::test {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(InfoOnAProject, SaysWhichEffectsAndWhy) {
  const Ending ending = talus_cli({"info", sample("free_fall"), "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const Json info = Json::parse(ending.out);
  std::vector<std::string> on;
  for (const Json& effect : info["effects"]) {
    EXPECT_FALSE(effect["reason"].get<std::string>().empty());
    if (effect["active"]) on.push_back(effect["name"]);
    EXPECT_EQ(effect["estimated_seconds_an_iteration"] > 0, effect["active"]) << effect;
    EXPECT_EQ(!effect["items"].get<std::string>().empty(), effect["active"]) << effect;
  }
  EXPECT_THAT(on, ElementsAre("elasticity", "inertia", "body force", "acceleration reset", "sleep"));
  EXPECT_THAT(talus_cli({"info", sample("free_fall")}).out, HasSubstr("nothing can touch"));
}

TEST(InfoOnAProject, LooksAheadAtARunOnlyWhereItIsAskedTo) {
  const std::string project = sample("jointed_bench");
  const Json info = Json::parse(talus_cli({"info", project, "--json"}).out);
  EXPECT_FALSE(info.contains("forecast"));
  EXPECT_GT(info["blocks"].size(), 200u);
  EXPECT_EQ(Json::parse(talus_cli({"info", project, "--json", "--no-forecast"}).out), info) << "as it was said before";
  const Ending asked = talus_cli({"info", sample("free_fall"), "--json", "--forecast"});
  EXPECT_GT(Json::parse(asked.out)["forecast"]["steps"], 0);
}

}  // namespace
}  // namespace talus::test
