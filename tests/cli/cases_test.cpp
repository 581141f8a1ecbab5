#include <gmock/gmock.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "process.hpp"

// Studies of many cases as users run them: every case is a process of its own.
namespace talus::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::HasSubstr;

class CaseStudies : public testing::Test {
 protected:
  std::vector<std::string> command(const std::string& project, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"study", "cases", project, "--out", folder().string(), "--jobs", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  std::string table(const std::string& text) const {
    write_text(folder_ / "table.csv", text);
    return (folder_ / "table.csv").string();
  }
  fs::path folder() const { return folder_ / "study"; }
  Json json() const { return Json::parse(text_of(folder() / "cases.json")); }

  Folder folder_;
};

TEST_F(CaseStudies, SolveAProjectUnderTheValuesOfATable) {
  const std::string values =
      table("case,/joints/J1/friction_angle,/solids/block/body\nown,,\nsteep,28,rigid\nstill,35,\n");
  const Ending ending = talus_cli(command(sample("incline_slide"), {"--table", values}));
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, HasSubstr("3 of 3 cases completed"));
  EXPECT_THAT(text_of(folder() / "cases.csv"), HasSubstr("case,project,status,/joints/J1/friction_angle,"));
  const Json cases = json()["cases"];
  // The acceleration of a block on a plane of 30°, for 1 s: g (sin 30° − tan φ cos 30°) / 2.
  EXPECT_NEAR(cases[0]["numbers"]["farthest"], 1.31429, 1e-3);
  EXPECT_NEAR(cases[1]["numbers"]["farthest"], 0.19393, 1e-3);
  EXPECT_EQ(cases[2]["numbers"]["moved_blocks"], 0);
  EXPECT_EQ(cases[1]["numbers"]["tetrahedra"], 0) << "the case is rigid";
  EXPECT_TRUE(fs::exists(folder() / "runs" / "001.results" / "results.h5"));

  // a further case is the only one that is run
  const auto written = fs::last_write_time(folder() / "runs" / "001.json");
  table(text_of(values) + "more,20,\n");
  ASSERT_EQ(talus_cli(command(sample("incline_slide"), {"--table", values, "--json"})).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(folder() / "runs" / "001.json"), written);
  EXPECT_EQ(json()["cases"].size(), 4u);
}

TEST_F(CaseStudies, SolveAFolderOfProjectsAndGoOnWhereOneFails) {
  fs::copy_file(sample("free_fall"), folder_ / "fall.talus");
  Json torn = Json::parse(text_of(sample("free_fall")), nullptr, true, true);
  torn["solids"][0].erase("box");
  torn["solids"][0]["file"] = "stone.stl";
  write_text(folder_ / "stone.stl", "solid nothing\nendsolid nothing\n");
  write_text(folder_ / "torn.talus", torn.dump());
  const Ending ending = talus_cli(command(folder_.path().string(), {"--drop-results"}));
  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_THAT(ending.out, HasSubstr("1 of 2 cases completed"));
  const Json cases = json()["cases"];
  EXPECT_EQ(cases[0]["case"], "fall");
  EXPECT_EQ(cases[0]["status"], "completed");
  EXPECT_EQ(cases[1]["status"], "failed");
  EXPECT_THAT(cases[1]["reason"].get<std::string>(), HasSubstr("stone.stl"));
  EXPECT_FALSE(fs::exists(folder() / "runs" / "000.results"));
}

/// The same as long as the file is not made anew.
ino_t file_number(const fs::path& file) {
  struct stat status {};
  EXPECT_EQ(stat(file.c_str(), &status), 0) << file;
  return status.st_ino;
}

TEST_F(CaseStudies, ThatWereKilledGoOnFromTheirCheckpoints) {
  const std::string values = table("/joints/J1/friction_angle\n15\n16\n");
  Json project = Json::parse(text_of(sample("incline_slide")), nullptr, true, true);
  project["solids"][1]["mesh_size"] = 0.2;
  project["stages"][1]["time_step"] = 0.002;
  write_text(folder_ / "slow.talus", project.dump());
  const auto study = command((folder_ / "slow.talus").string(), {"--table", values});
  const auto steps_of = [&](const char* run) {
    const fs::path file = folder() / "runs" / run / "steps.csv";
    if (!fs::exists(file)) return std::ptrdiff_t{0};
    const std::string text = text_of(file);
    return std::count(text.begin(), text.end(), '\n');
  };
  {
    Cli cli(study);
    while (steps_of("000.results") < 30 || steps_of("001.results") < 30)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    cli.send(SIGINT);
    EXPECT_EQ(cli.wait().exit_code, 1);
  }
  ASSERT_FALSE(fs::exists(folder() / "runs" / "000.json")) << "it was over before it was stopped";
  const fs::path results = folder() / "runs" / "000.results" / "results.h5";
  const auto begun = file_number(results);
  const Ending again = talus_cli(study);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(file_number(results), begun) << "it began anew";

  // and they come to the same as one that was left alone
  auto calm = study;
  calm[4] = (folder_ / "calm").string();
  ASSERT_EQ(talus_cli(calm).exit_code, 0);
  const Json disturbed = json()["cases"], calm_cases = Json::parse(text_of(folder_ / "calm" / "cases.json"))["cases"];
  for (const char* number : {"farthest", "front", "P1.displacement", "steps"})
    EXPECT_EQ(disturbed[0]["numbers"][number], calm_cases[0]["numbers"][number]) << number;
}

TEST_F(CaseStudies, WrongTablesAreOneLine) {
  for (const auto& [text, expected] : std::vector<std::pair<std::string, std::string>>{
           {"/joints/J1/friction_angle\n30\n95\n", "line 3, column /joints/J1/friction_angle: must be below 90"},
           {"/joints/J7/friction_angle\n30\n", "column /joints/J7/friction_angle: the project has no 'J7'"},
           {"friction\n30\n", "line 1, column friction: is no place in a project"}}) {
    const Ending ending = talus_cli(command(sample("incline_slide"), {"--table", table(text)}));
    EXPECT_EQ(ending.exit_code, 2);
    EXPECT_THAT(ending.err, HasSubstr("table.csv: " + expected));
    EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1);
  }
  EXPECT_FALSE(fs::exists(folder()));
}

}  // namespace
}  // namespace talus::test
