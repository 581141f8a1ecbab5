#include <gmock/gmock.h>

#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "process.hpp"

// Bad input of every kind: exit code 2, one line that says file, place, problem and remedy, and nothing left behind.
namespace talus::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// Two boxes, one on the other, that solve in no time.
Json good_project() {
  return Json::parse(R"({
    "talus": 1, "name": "Two boxes",
    "materials": { "rock": {"density": 2600, "young": 25e9, "poisson": 0.24} },
    "joints": { "J1": {"friction_angle": 30} },
    "default_joint": "J1",
    "solids": [
      {"name": "ground", "box": {"min": [-1, -1, -1], "max": [1, 1, 0]}, "material": "rock", "body": "fixed", "mesh_size": 2},
      {"name": "box", "box": {"min": [-0.5, -0.5, 0], "max": [0.5, 0.5, 1]}, "material": "rock", "mesh_size": 1}
    ],
    "stages": [ {"name": "rest", "type": "dynamic", "time_step": 0.01, "steps": 2} ]
  })");
}

Json tetrahedron(const std::vector<std::vector<int>>& faces) {
  return {{"name", "wedge"},
          {"polyhedron", {{"vertices", {{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {0, 0, 3}}}, {"faces", faces}}},
          {"material", "rock"}};
}

class BadInput : public testing::Test {
 protected:
  void expect_text_refused(const std::string& text, const std::string& what) {
    const auto project = folder_ / "bad.talus", results = folder_ / "out.results";
    write_text(project, text);
    const Ending ending = talus_cli({"solve", project.string(), "--out", results.string()});
    EXPECT_EQ(ending.exit_code, 2) << ending.err;
    EXPECT_EQ(ending.out, "");
    EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1) << ending.err;
    EXPECT_THAT(ending.err, StartsWith("talus-cli: " + project.string() + ": "));
    EXPECT_THAT(ending.err, HasSubstr("; ")) << "no remedy";
    EXPECT_THAT(ending.err, HasSubstr(what));
    EXPECT_FALSE(std::filesystem::exists(results));
  }
  void expect_refused(const Json& project, const std::string& what) { expect_text_refused(project.dump(2), what); }

  Folder folder_;
  Json project_ = good_project();
};

TEST_F(BadInput, APipeOrADeviceIsNoProject) {
  const std::string pipe = (folder_ / "pipe.talus").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& file : {pipe, std::string("/dev/zero")}) {
    const Ending ending = talus_cli({"info", file});
    EXPECT_EQ(ending.exit_code, 2);
    EXPECT_EQ(ending.err, "talus-cli: " + file + ": cannot be read: it is a pipe or a device; write it into a file\n");
  }
}

TEST_F(BadInput, StandardOutputThatIsFullIsTold) {
  const auto err = folder_ / "err";
  const std::string command = TALUS_CLI " verify --list > /dev/full 2> " + err.string();
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
  EXPECT_EQ(text_of(err), "talus-cli: standard output cannot be written; is the disk full?\n");
}

TEST_F(BadInput, TheProjectItselfIsGood) {
  write_text(folder_ / "good.talus", project_.dump());
  const Ending ending = talus_cli({"solve", (folder_ / "good.talus").string()});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "good.results")) << "the default folder lies beside the project";
}

TEST_F(BadInput, MissingFile) {
  const auto results = folder_ / "out.results";
  const Ending ending = talus_cli({"solve", (folder_ / "none.talus").string(), "--out", results.string()});
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1) << ending.err;
  EXPECT_THAT(ending.err, HasSubstr("none.talus"));
  EXPECT_FALSE(std::filesystem::exists(results));
}

TEST_F(BadInput, MalformedJson) { expect_text_refused("{ \"talus\": 1,\n  \"name\" \"x\" }\n", "line 2"); }

TEST_F(BadInput, ALongKeyMakesNoLongMessage) {
  project_["materials"]["rock"][std::string(5000, 'x')] = 1;
  write_text(folder_ / "bad.talus", project_.dump());
  const Ending ending = talus_cli({"info", (folder_ / "bad.talus").string()});
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_LT(ending.err.size(), 500u);
  EXPECT_THAT(ending.err, HasSubstr("/materials/rock/x"));
  EXPECT_THAT(ending.err, HasSubstr("use one of"));
}

TEST_F(BadInput, MassesAndStiffnessesTooFarApart) {
  project_["materials"]["rock"]["density"] = 1e-300;
  project_["solids"][1].update(
      {{"box", {{"min", {-0.5, -0.5, 1}}, {"max", {0.5, 0.5, 2}}}}, {"body", "tetrahedra"}, {"mesh_size", 0.5}});
  write_text(folder_ / "bad.talus", project_.dump());
  const Ending ending = talus_cli({"solve", "-q", (folder_ / "bad.talus").string()});
  EXPECT_EQ(ending.exit_code, 2) << ending.err;
  EXPECT_THAT(ending.err, HasSubstr("too far apart"));
}

TEST_F(BadInput, AFileNameThatIsNoUtf8IsNoFault) {
  const std::string name = (folder_ / "f\xff").string();
  write_text(name + ".talus", project_.dump());
  const Ending ending = talus_cli({"solve", "-q", "--json", name + ".talus", "--out", name + ".results"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(Json::parse(ending.out).at("results"), testing::EndsWith("f\uFFFD.results"));
}

TEST_F(BadInput, NotANumber) { expect_text_refused("{ \"talus\": 1, \"gravity\": [0, 0, NaN] }\n", "line 1"); }

TEST_F(BadInput, UnknownKey) {
  project_["materials"]["rock"]["colour"] = "grey";
  expect_refused(project_, "colour");
}

TEST_F(BadInput, NegativeDensity) {
  project_["materials"]["rock"]["density"] = -2600;
  expect_refused(project_, "/materials/rock/density");
}

TEST_F(BadInput, PoissonsRatioOfOneHalf) {
  project_["materials"]["rock"]["poisson"] = 0.5;
  expect_refused(project_, "/materials/rock/poisson");
}

TEST_F(BadInput, OpenPolyhedron) {
  project_["solids"].push_back(tetrahedron({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}));
  expect_refused(project_, "/solids/2/polyhedron");
}

TEST_F(BadInput, PolyhedronInsideOut) {
  project_["solids"].push_back(tetrahedron({{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}));
  expect_refused(project_, "/solids/2/polyhedron");
}

TEST_F(BadInput, OverlappingSolids) {
  project_["solids"][1]["box"]["min"] = {-0.5, -0.5, -0.25};
  expect_refused(project_, "overlap");
}

TEST_F(BadInput, JointThatIsNotDefined) {
  project_["default_joint"] = "J9";
  expect_refused(project_, "J9");
}

TEST_F(BadInput, CutThatMisses) {
  project_["cuts"] = {{{"joint", "J1"}, {"dip", 0}, {"dip_direction", 0}, {"through", {0, 0, 50}}}};
  expect_refused(project_, "cut 1 (J1): misses every solid");
}

TEST_F(BadInput, TimeStepOfZero) {
  project_["stages"][0]["time_step"] = 0;
  expect_refused(project_, "/stages/0/time_step");
}

TEST_F(BadInput, StepFileThatIsNone) {
  write_text(folder_ / "hill.step", "this is no STEP file\n");
  project_["solids"].push_back({{"name", "hill"}, {"file", "hill.step"}, {"material", "rock"}});
  expect_refused(project_, "hill.step");
}

TEST_F(BadInput, StepFileThatIsMissing) {
  project_["solids"].push_back({{"name", "hill"}, {"file", "hill.step"}, {"material", "rock"}});
  expect_refused(project_, "hill.step");
}

TEST_F(BadInput, FolderThatHoldsOtherThingsIsNotEmptied) {
  write_text(folder_ / "good.talus", project_.dump());
  std::filesystem::create_directory(folder_ / "mine");
  write_text(folder_ / "mine/letter.txt", "keep me");
  const Ending ending = talus_cli({"solve", (folder_ / "good.talus").string(), "--out", (folder_ / "mine").string()});
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_EQ(text_of(folder_ / "mine/letter.txt"), "keep me");
}

struct Usage {
  const char* name;
  std::vector<std::string> arguments;
};

class BadUsage : public testing::TestWithParam<Usage> {};

TEST_P(BadUsage, IsOneLineThatPointsToTheHelp) {
  const Ending ending = talus_cli(GetParam().arguments);
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_EQ(ending.out, "");
  EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1) << ending.err;
  EXPECT_THAT(ending.err, StartsWith("talus-cli: usage: "));
  EXPECT_THAT(ending.err, HasSubstr("--help"));
}

INSTANTIATE_TEST_SUITE_P(
    Cli, BadUsage,
    testing::Values(Usage{"no_command", {}}, Usage{"unknown_command", {"fly"}},
                    Usage{"unknown_option", {"mesh", "x.talus", "--fast"}}, Usage{"no_project", {"solve"}},
                    Usage{"threads", {"solve", "x.talus", "--threads", "0"}},
                    Usage{"size", {"render", "x", "--out", "p.png", "--size", "wide"}},
                    Usage{"theme", {"render", "x", "--out", "p.png", "--theme", "pink"}},
                    Usage{"time_and_frame", {"render", "x", "--out", "p.png", "--time", "1", "--frame", "1"}},
                    Usage{"threshold", {"render", "x", "--out", "p.png", "--compare", "q.png", "--threshold", "nan"}},
                    Usage{"threshold_alone", {"render", "x", "--out", "p.png", "--threshold", "0.5"}},
                    Usage{"fps", {"animate", "x", "--out", "f.mp4", "--fps", "0"}},
                    Usage{"format", {"export", "x", "--out", "d", "--as", "xls"}}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace talus::test
