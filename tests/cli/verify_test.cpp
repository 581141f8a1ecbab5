#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "process.hpp"

// Known answers and hard cases by talus-cli verify: what it prints and writes, how it ends.
namespace talus::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class Verify : public testing::Test {
 protected:
  std::string place(const std::string& name) const { return (folder / name).string(); }

  Folder folder;
};

TEST_F(Verify, RunsTheNamedCases) {
  const Ending ending = talus_cli({"verify", "samples/free_fall", "--json"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  const Json result = Json::parse(ending.out);
  ASSERT_EQ(result["cases"].size(), 1U);
  EXPECT_EQ(result["cases"][0]["checks"].size(), 5U);
  EXPECT_LT(result["cases"][0]["checks"][1]["error"], 1e-10);
  EXPECT_GT(result["cases"][0]["seconds"], 0);
}

TEST_F(Verify, RunsWithRigidBlocksWhereNoStrainIsAskedFor) {
  const Ending rigid = talus_cli({"verify", "block_slides", "--body", "rigid", "--json"});
  EXPECT_EQ(rigid.exit_code, 0) << rigid.err;
  EXPECT_EQ(Json::parse(rigid.out)["cases"].size(), 1U);
  const Ending strain = talus_cli({"verify", "patch_test", "--body", "rigid"});
  EXPECT_EQ(strain.exit_code, 2);
  EXPECT_THAT(strain.err, HasSubstr("case 'patch_test': asks for strain"));
  EXPECT_EQ(talus_cli({"verify", "--body", "stone"}).exit_code, 2);
}

TEST_F(Verify, RunsToAnotherToleranceByNameOrNumber) {
  const auto iterations = [](const char* tolerance) {
    const Ending ending =
        talus_cli({"verify", "--hard-cases", "incline_1_degree_slides", "--tolerance", tolerance, "--json"});
    return Json::parse(ending.out)["scenes"][0]["iterations_per_step"].get<double>();
  };
  const double reference = iterations("reference");
  EXPECT_LT(iterations("draft"), reference);
  EXPECT_EQ(iterations("1e-10"), reference);
  const Ending known = talus_cli({"verify", "block_slides", "--tolerance", "standard", "--json"});
  EXPECT_EQ(known.exit_code, 0) << known.err;
  for (const char* wrong : {"standart", "0.5", "1e-6 N"}) {
    const Ending refused = talus_cli({"verify", "block_slides", "--tolerance", wrong});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("write draft, standard, reference, or a number from 1e-12 to 0.01"));
  }
}

TEST_F(Verify, RunsByThePapersScheme) {
  const auto passes = [](const char* preset) {
    const Ending ending = talus_cli({"verify", "block_stops", "--preset", preset, "--json"});
    return Json::parse(ending.out)["cases"][0]["passed"].get<bool>();
  };
  EXPECT_TRUE(passes("talus"));
  EXPECT_FALSE(passes("paper")) << "friction that lags behind creeps";
  EXPECT_EQ(talus_cli({"verify", "block_stops", "--preset", "other"}).exit_code, 2);
}

TEST_F(Verify, EndsWithOneWhenACaseFails) {
  std::filesystem::create_directories(folder / "samples/wrong");
  Json project = Json::parse(text_of(sample("free_fall")));
  project["expect"][1]["value"] = -5;
  write_text(folder / "samples/wrong/wrong.talus", project.dump());
  const Ending ending = talus_cli({"verify", "wrong", "--samples", place("samples")});
  EXPECT_EQ(ending.exit_code, 1) << ending.err;
  EXPECT_THAT(ending.out, HasSubstr("0 of 1 cases passed"));
}

TEST_F(Verify, PrintsACaseOnceWithUnitsAndItsSource) {
  const Ending ending = talus_cli({"verify", "samples/free_fall", "--repeat"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, HasSubstr("samples/free_fall: Free fall: passed"));
  EXPECT_THAT(ending.out, HasSubstr("P1.velocity.z at 1 s"));
  EXPECT_THAT(ending.out, HasSubstr("m/s"));
  EXPECT_THAT(ending.out, HasSubstr("2 threads, scale 1: the same bits"));
  EXPECT_THAT(ending.out, HasSubstr("1 thread, scale 0.1: the same"));
  EXPECT_THAT(ending.out, HasSubstr("Source: -g t^2 / 2; -g t; no force along x"));
  EXPECT_EQ(ending.out.find("free_fall"), ending.out.rfind("free_fall"));
}

TEST_F(Verify, RunsAtAnotherScale) {
  const Ending ending = talus_cli({"verify", "samples/free_fall", "--scale", "0.01", "--json"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  const Json check = Json::parse(ending.out)["cases"][0]["checks"][1];
  EXPECT_NEAR(check["expected"], -0.04905, 1e-15);
  EXPECT_LT(check["error"], 1e-10);
}

TEST_F(Verify, WritesItsTableIntoAPageAndKeepsTheRest) {
  write_text(folder / "page.md",
             "# Prose\n<!-- talus-cli verify: begin -->\nold\n<!-- talus-cli verify: end -->\nEnd\n");
  const Ending ending = talus_cli({"verify", "samples/free_fall", "--markdown", place("page.md")});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  const std::string page = text_of(place("page.md"));
  EXPECT_THAT(page, testing::StartsWith("# Prose\n<!-- talus-cli verify: begin -->\n"));
  EXPECT_THAT(page, testing::EndsWith("<!-- talus-cli verify: end -->\nEnd\n"));
  EXPECT_THAT(page, HasSubstr("| [samples/free_fall](#samplesfree_fall) | Free fall | 5 |"));
  EXPECT_THAT(page, testing::Not(HasSubstr("old")));

  write_text(folder / "plain.md", "# Prose\n");
  const Ending refused = talus_cli({"verify", "samples/free_fall", "--markdown", place("plain.md")});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("has no part for the tables of verify"));
  EXPECT_EQ(text_of(place("plain.md")), "# Prose\n");
}

TEST_F(Verify, ListsAllCasesAndWhichTakeLong) {
  const Ending ending = talus_cli({"verify", "--list"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, testing::ContainsRegex("samples/free_fall +always +Free fall"));
  EXPECT_THAT(ending.out, testing::ContainsRegex("samples/jiweishan +with --all +Jiweishan rockslide"));
  const Json list = Json::parse(talus_cli({"verify", "--list", "--json"}).out);
  EXPECT_GE(list["cases"].size(), 5U);
}

TEST_F(Verify, NamesTheCasesThereAre) {
  const Ending ending = talus_cli({"verify", "perpetual_motion"});
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_THAT(ending.err, HasSubstr("free_fall"));
}

TEST_F(Verify, RunsHardCasesARowEach) {
  const Ending ending = talus_cli({"verify", "--hard-cases", "incline_1_degree_slides", "--repeat"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, testing::ContainsRegex("incline_1_degree_slides +completed +.* yes\n"));
  EXPECT_THAT(ending.out, HasSubstr("1 of 1 scenes passed"));
  const Ending json = talus_cli({"verify", "--hard-cases", "incline_1_degree_slides", "--json"});
  const Json scene = Json::parse(json.out)["scenes"][0];
  EXPECT_EQ(scene["group"], "thresholds");
  EXPECT_EQ(scene["faults"].size(), 0U);
  EXPECT_GT(scene["penetration"], 0);
}

TEST_F(Verify, WritesHardCasesIntoAPage) {
  write_text(folder / "page.md", "# Prose\n<!-- talus-cli verify: begin -->\n<!-- talus-cli verify: end -->\n");
  const Ending ending =
      talus_cli({"verify", "--hard-cases", "incline_1_degree_slides", "--markdown", place("page.md")});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(text_of(place("page.md")), HasSubstr("### thresholds\n\n| Scene | What | Must come to |"));
  EXPECT_THAT(text_of(place("page.md")), HasSubstr("| incline_1_degree_slides | Block on 30°, rigid"));
}

TEST_F(Verify, ListsTheHardCasesAndTheirGroups) {
  const Ending ending = talus_cli({"verify", "--hard-cases", "--list", "--group", "thresholds"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, testing::ContainsRegex("incline_1_degree_slides +thresholds +always +Block on 30°"));
  const Ending unknown = talus_cli({"verify", "--hard-cases", "--group", "geese"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("group 'geese'"));
  EXPECT_EQ(talus_cli({"verify", "--group", "thresholds"}).exit_code, 2) << "only known with --hard-cases";
  EXPECT_EQ(talus_cli({"verify", "--hard-cases", "--scale", "2"}).exit_code, 2);
}

TEST_F(Verify, DrawsRandomScenesAndReplaysThemByTheirNames) {
  const Ending drawn =
      talus_cli({"verify", "--random", "2", "--seed", "3", "--family", "inclines", "--body", "rigid", "--json"});
  const Json all = Json::parse(drawn.out);
  EXPECT_EQ(drawn.exit_code, all["passed"] ? 0 : 1) << drawn.err;
  ASSERT_EQ(all["scenes"].size(), 2U);
  EXPECT_EQ(all["families"][0]["scenes"], 2);
  const Json second = all["scenes"][1];
  EXPECT_EQ(second["scene"], "inclines:3:2:rigid");
  const Ending again = talus_cli({"verify", "--random-scene", "inclines:3:2:rigid", "--json"});
  EXPECT_EQ(Json::parse(again.out)["scenes"][0]["fingerprint"], second["fingerprint"]);
}

TEST_F(Verify, RunsRandomScenesElsewhereAndByOtherSettings) {
  const Ending ending = talus_cli(
      {"verify", "--random", "1", "--seed", "3", "--family", "towers", "--elsewhere", "--other-settings", "--json"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  const Json scene = Json::parse(ending.out)["scenes"][0];
  EXPECT_EQ(scene["scene"], "towers:3:1:settings");
  EXPECT_EQ(scene["elsewhere"]["same"], true);
  EXPECT_LT(scene["elsewhere"]["apart"], 1e-9);
  EXPECT_EQ(talus_cli({"verify", "--random-scene", "towers:3:1:settings"}).exit_code, 0);
}

TEST_F(Verify, PrintsASeedOfNowAndATableOfFamilies) {
  const Ending ending = talus_cli({"verify", "--random", "1", "--seed", "now", "--family", "inclines"});
  EXPECT_THAT(ending.err, testing::ContainsRegex("talus-cli: seed [0-9]+\n"));
  EXPECT_THAT(ending.out, testing::ContainsRegex("Family +Scenes +Held +Seconds"));
}

/// A small body that flies at a wall by many of its sizes a step makes energy there.
TEST_F(Verify, EndsWithOneAndWritesRandomScenesThatFail) {
  write_text(folder / "page.md", "<!-- talus-cli verify: begin -->\n<!-- talus-cli verify: end -->\n");
  const Ending ending = talus_cli(
      {"verify", "--random-scene", "impacts:52525:5979", "--out", place("failed"), "--markdown", place("page.md")});
  EXPECT_EQ(ending.exit_code, 1) << ending.err;
  EXPECT_THAT(ending.out, HasSubstr("failed: impacts:52525:5979"));
  const std::string file = text_of(folder / "failed/impacts-52525-5979.talus");
  EXPECT_THAT(file, HasSubstr("// - energy grows by"));
  EXPECT_EQ(talus_cli({"info", place("failed/impacts-52525-5979.talus")}).exit_code, 0);
  EXPECT_THAT(text_of(place("page.md")), HasSubstr("- **impacts:52525:5979**"));
}

TEST_F(Verify, ListsTheFamiliesOfRandomScenes) {
  const Ending ending = talus_cli({"verify", "--random", "1", "--list"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, testing::ContainsRegex("impacts +A body that flies"));
}

TEST_F(Verify, RefusesRandomScenesThereAreNot) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"verify", "--random", "1", "--family", "geese"},
                                             {"verify", "--random", "1", "--seed", "1x"},
                                             {"verify", "--random", "0"},
                                             {"verify", "--random-scene", "impacts:1"},
                                             {"verify", "--random", "1", "--hard-cases"},
                                             {"verify", "--hard-cases", "--elsewhere"},
                                             {"verify", "--elsewhere"},
                                             {"verify", "--other-settings"},
                                             {"verify", "--seed", "1"},
                                             {"verify", "block_slides", "--body", "mixed"}})
    EXPECT_EQ(talus_cli(arguments).exit_code, 2) << arguments[1] << ' ' << arguments[2];
}

}  // namespace
}  // namespace talus::test
