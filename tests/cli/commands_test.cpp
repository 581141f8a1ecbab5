#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "process.hpp"

// Every command on a small sample: what it prints, what it writes, how it ends.
namespace talus::test {
namespace {

using Json = nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;

/// Width and height from a PNG's header; zeros for what is no PNG.
std::pair<int, int> png_size(const std::filesystem::path& file) {
  const std::string bytes = text_of(file);
  if (bytes.size() < 24 || bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0) return {0, 0};
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  return {number(16), number(20)};
}

/// Characters of UTF-8 text.
auto columns_of(const std::string& line) {
  return std::count_if(line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
}

/// The results of free_fall, solved once for all tests.
class Commands : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<Folder>();
    solved = talus_cli({"solve", sample("free_fall"), "--out", results(), "--json"});
  }
  static void TearDownTestSuite() { folder.reset(); }

  static std::string results() { return (*folder / "fall.results").string(); }
  static std::string place(const std::string& name) { return (*folder / name).string(); }

  static std::unique_ptr<Folder> folder;
  static Ending solved;
};

std::unique_ptr<Folder> Commands::folder;
Ending Commands::solved;

TEST_F(Commands, SolvePrintsTheSummaryAsOneJsonObject) {
  ASSERT_EQ(solved.exit_code, 0) << solved.err;
  const Json summary = Json::parse(solved.out);
  EXPECT_EQ(summary["status"], "completed");
  EXPECT_EQ(summary["steps"], 100);
  EXPECT_NEAR(summary["time"].get<double>(), 1, 1e-12);
  EXPECT_EQ(summary["results"], results());
  EXPECT_EQ(summary["expect"].size(), 5U);
  for (const Json& effect : summary["effects"]) {
    EXPECT_EQ(effect["built"], effect["active"] ? 1 : 0) << effect;
    EXPECT_EQ(effect["evaluations"] > 0, effect["active"]) << effect;
  }
  EXPECT_GT(summary["iterations"], 0);
  EXPECT_GE(summary["work"]["linear_solves"], summary["iterations"]);
  EXPECT_EQ(summary["work"]["contact_points"], 0);
  for (const char* file : {"results.h5", "results.vtkhdf", "results.xdmf", "frames.h5", "history.csv", "steps.csv",
                           "summary.json", "project.talus"})
    EXPECT_TRUE(std::filesystem::exists(*folder / "fall.results" / file)) << file;
}

TEST_F(Commands, SolveWithoutJsonIsForReaders) {
  const Ending ending = talus_cli({"solve", sample("free_fall"), "--out", place("again.results")});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_EQ(ending.out.substr(0, 10), "completed\n");
  EXPECT_THAT(ending.out, HasSubstr("P1.displacement.z"));
  EXPECT_THAT(
      ending.out,
      HasSubstr("\nOff: neo-Hookean elasticity, initial stress, displacement constraint, point load, normal contact,"));
  EXPECT_THAT(ending.out, HasSubstr("\nelasticity "));
  EXPECT_THAT(ending.out, HasSubstr("\nContacts: 0 points (0 a step)"));
  EXPECT_THAT(ending.out, HasSubstr("\nSleep: no block slept"));
}

TEST_F(Commands, SolveEndsWithOneWhenAnExpectationIsMissed) {
  Json project = Json::parse(text_of(sample("free_fall")));
  project["expect"][0]["value"] = -1.3;
  write_text(*folder / "wrong.talus", project.dump());
  const Ending ending = talus_cli({"solve", place("wrong.talus"), "--out", place("wrong.results"), "--json"});
  EXPECT_EQ(ending.exit_code, 1) << ending.err;
  const Json summary = Json::parse(ending.out);
  EXPECT_EQ(summary["expect"][0]["passed"], false);
  EXPECT_EQ(summary["expect"][1]["passed"], true);
}

TEST_F(Commands, MeshTellsBlocks) {
  const Ending ending = talus_cli({"mesh", sample("incline_slide"), "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const Json mesh = Json::parse(ending.out);
  ASSERT_EQ(mesh["blocks"].size(), 2U);
  EXPECT_EQ(mesh["blocks"][0]["name"], "slope");
  EXPECT_EQ(mesh["blocks"][0]["body"], "fixed");
  EXPECT_EQ(mesh["blocks"][1]["name"], "block");
  EXPECT_NEAR(mesh["blocks"][1]["volume"].get<double>(), 0.5, 1e-9);
  EXPECT_GT(mesh["blocks"][1]["tetrahedra"], 4);
  EXPECT_GT(mesh["blocks"][1]["quality"]["worst"], 0.05);
  EXPECT_LE(mesh["blocks"][1]["quality"]["mean"], 1.0);
  EXPECT_GT(mesh["blocks"][0]["quality"]["worst"], 0.05) << "fixed, and meshed to the size that it has";
  EXPECT_THAT(talus_cli({"mesh", sample("incline_slide")}).out, HasSubstr("Volume [m³]"));
}

TEST_F(Commands, MeshDoesNotRateBlocksThatStandOnTheirCorners) {
  Json project = Json::parse(text_of(sample("incline_slide")), nullptr, true, true);
  project["solids"][0].erase("mesh_size");
  write_text(*folder / "corners.talus", project.dump());
  const Json mesh = Json::parse(talus_cli({"mesh", place("corners.talus"), "--json"}).out);
  EXPECT_EQ(mesh["blocks"][0]["nodes"], 9);
  EXPECT_TRUE(mesh["blocks"][0]["quality"].is_null());
  EXPECT_FALSE(mesh["blocks"][1]["quality"].is_null());
  const std::string table = talus_cli({"mesh", place("corners.talus")}).out;
  EXPECT_THAT(table, HasSubstr("12              –             –\n"));
  EXPECT_THAT(table, HasSubstr("– where a block stands on its corners"));
}

TEST_F(Commands, InspectSaysWhatTheSolidsAre) {
  const Ending ending = talus_cli({"inspect", sample("incline_slide"), "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const Json solids = Json::parse(ending.out)["solids"];
  ASSERT_EQ(solids.size(), 2U);
  EXPECT_EQ(solids[1]["name"], "block");
  EXPECT_NEAR(solids[1]["volume"].get<double>(), 0.5, 1e-9);
  EXPECT_EQ(solids[1]["closed"], true);
  EXPECT_EQ(solids[1]["findings"], Json::array());
  EXPECT_THAT(talus_cli({"inspect", sample("incline_slide")}).out, HasSubstr("Closed"));
}

TEST_F(Commands, InspectFailsForASurfaceThatIsOpen) {
  const std::filesystem::path project = *folder / "open.talus";
  std::ofstream(*folder / "open.stl") << "solid s\n"
                                         "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\n"
                                         "endloop\nendfacet\n"
                                         "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\n"
                                         "endloop\nendfacet\nendsolid s\n";
  std::ofstream(project) << R"({"talus": 1, "name": "open",
    "materials": {"rock": {"density": 2600, "young": 1e10, "poisson": 0.2}},
    "solids": [{"name": "rock", "file": "open.stl", "material": "rock"}]})";
  const Ending ending = talus_cli({"inspect", project.string()});
  EXPECT_EQ(ending.exit_code, 1) << ending.err;
  EXPECT_THAT(ending.out, HasSubstr("rock: 1 hole: close the surface"));
}

/// A block on a plane of 30°: F = tan 15° / tan 30°.
TEST_F(Commands, BlocksSaysWhichCanLeaveAndHow) {
  const Ending ending = talus_cli({"blocks", sample("incline_slide"), "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const Json blocks = Json::parse(ending.out)["blocks"];
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_EQ(blocks[0]["fixed"], true);
  EXPECT_EQ(blocks[1]["leaving"], "slides on one face");
  EXPECT_EQ(blocks[1]["neighbours"], Json({"slope"}));
  EXPECT_EQ(blocks[1]["free_faces"], 5);
  EXPECT_NEAR(blocks[1]["plunge"].get<double>(), 30, 1e-9);
  EXPECT_NEAR(blocks[1]["factor_of_safety"].get<double>(), std::tan(M_PI / 12) / std::tan(M_PI / 6), 1e-9);
  EXPECT_THAT(talus_cli({"blocks", sample("incline_slide")}).out, HasSubstr("slides on one face"));
}

TEST_F(Commands, MeshAndInfoSayWhatAutoBecameAndWhy) {
  for (const char* command : {"mesh", "info"}) {
    const Ending ending = talus_cli({command, sample("block_ladder"), "--json"});
    ASSERT_EQ(ending.exit_code, 0) << ending.err;
    for (const Json& block : Json::parse(ending.out)["blocks"]) {
      if (block["name"] != "auto") {
        EXPECT_FALSE(block.contains("body_reason")) << block;
        continue;
      }
      EXPECT_EQ(block["body"], "rigid");
      EXPECT_THAT(block["body_reason"].get<std::string>(), HasSubstr("strains it by 2.7e-6"));
    }
    EXPECT_THAT(talus_cli({command, sample("block_ladder")}).out,
                HasSubstr("Body auto became\n  rigid: hard rock: the model's weight strains it by 2.7e-6; "
                          "nobody asks for its stress\n    auto\n"));
  }
}

TEST_F(Commands, ReasonsAndNamesAreBrokenAtAHundredCharacters) {
  Json project = Json::parse(text_of(sample("free_fall")), nullptr, true, true);
  project["solids"] = Json::array();
  for (int i = 0; i < 12; ++i)
    project["solids"].push_back({{"name", "ein Block mit Überlänge " + std::to_string(i)},
                                 {"material", project["materials"].begin().key()},
                                 {"body", "auto"},
                                 {"box", {{"min", {2 * i, 0, 0}}, {"max", {2 * i + 1, 1, 1}}}}});
  for (const char* part : {"monitors", "expect"}) project.erase(part);
  project["joints"] = {{"J1", {{"friction_angle", 30}}}};
  project["default_joint"] = "J1";
  write_text(*folder / "many.talus", project.dump());
  const Ending ending = talus_cli({"mesh", place("many.talus")});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  std::istringstream lines(ending.out.substr(ending.out.find("Body auto became")));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    EXPECT_LE(columns_of(line), 100) << line;
  }
  EXPECT_EQ(count, 6) << ending.out;
}

TEST_F(Commands, InfoOnAProjectHasATableOfEffectsThatFitsATerminal) {
  const Ending ending = talus_cli({"info", sample("step_slope")});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  std::istringstream lines(ending.out.substr(ending.out.find("\nEffect ")));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(columns_of(line), 100) << line;
  EXPECT_THAT(ending.out, HasSubstr(" tetrahedra\n"));
  EXPECT_THAT(ending.out, HasSubstr(" contact points at the start\n"));
  EXPECT_THAT(ending.out, HasSubstr("An open-close iteration is estimated to spend"));
}

TEST_F(Commands, InfoOnResultsSaysWhatIsInThem) {
  const Ending ending = talus_cli({"info", results(), "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const Json info = Json::parse(ending.out);
  EXPECT_EQ(info["status"], "completed");
  EXPECT_EQ(info["steps"], 100);
  EXPECT_EQ(info["frames"], 21) << "the start and every 0.05 s of 1 s";
  EXPECT_EQ(info["monitors"], Json({"P1"}));
  const Json summary = Json::parse(text_of(*folder / "fall.results" / "summary.json"));
  EXPECT_EQ(info["effects"], summary["effects"]);
  EXPECT_EQ(info["work"], summary["work"]);
  const std::string text = talus_cli({"info", results()}).out;
  EXPECT_THAT(text, HasSubstr("completed, 100 steps, 21 frames"));
  EXPECT_THAT(text, HasSubstr("\nOff: neo-Hookean elasticity, initial stress, "));
  EXPECT_THAT(text, HasSubstr("\nEquations: "));
}

TEST_F(Commands, RenderDrawsAPictureOfTheSizeAskedFor) {
  const auto picture = place("p.png");
  const Ending ending = talus_cli({"render", results(), "--out", picture, "--size", "320x240", "--field",
                                   "displacement", "--time", "0.52", "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_EQ(png_size(picture), std::pair(320, 240));
  EXPECT_EQ(Json::parse(ending.out)["frame"], 10);
}

TEST_F(Commands, RenderShowsWhatItIsAskedFor) {
  const auto draw = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"render", results(), "--out", place("q.png"), "--size", "200x150"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(talus_cli(words).exit_code, 0);
    return text_of(place("q.png"));
  };
  const std::string last = draw({});
  EXPECT_EQ(last, draw({"--frame", "20"})) << "the last frame is the default, and the same picture comes twice";
  for (const std::vector<std::string>& other : std::vector<std::vector<std::string>>{{"--frame", "0"},
                                                                                     {"--view", "top"},
                                                                                     {"--view", "20,40"},
                                                                                     {"--theme", "dark"},
                                                                                     {"--edges", "mesh"},
                                                                                     {"--field", "velocity.z"}})
    EXPECT_NE(last, draw(other)) << other[0];
}

TEST_F(Commands, PicturesArePng) {
  const Ending ending = talus_cli({"render", results(), "--out", place("p.xyz"), "--size", "32x24"});
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_THAT(ending.err, HasSubstr("p.xyz: pictures are written as PNG; let the name end in .png"));
  EXPECT_FALSE(std::filesystem::exists(place("p.xyz")));
}

TEST_F(Commands, RenderRefusesWhatIsNotThere) {
  const auto refused = [&](std::vector<std::string> more, const std::string& what) {
    std::vector<std::string> words{"render", results(), "--out", place("none.png")};
    words.insert(words.end(), more.begin(), more.end());
    const Ending ending = talus_cli(words);
    EXPECT_EQ(ending.exit_code, 2);
    EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1) << ending.err;
    EXPECT_THAT(ending.err, HasSubstr(what));
    EXPECT_FALSE(std::filesystem::exists(place("none.png")));
  };
  refused({"--frame", "21"}, "frames 0 to 20");
  refused({"--time", "nan"}, "this is no time");
  refused({"--field", "temperature"}, "temperature");
  refused({"--view", "below"}, "below");
  refused({"--size", "4x4"}, "4");
}

TEST_F(Commands, RenderDrawsResultsSideBySide) {
  const std::string other = place("other.results");
  std::filesystem::copy(results(), other, std::filesystem::copy_options::recursive);
  const Ending both = talus_cli({"render", results(), other, "--out", place("both.png"), "--size", "641x200", "--field",
                                 "velocity", "--time", "0.5", "--json"});
  ASSERT_EQ(both.exit_code, 0) << both.err;
  const Json picture = Json::parse(both.out);
  EXPECT_EQ(png_size(place("both.png")), std::pair(641, 200));
  EXPECT_EQ(picture["time"], 0.5);
  EXPECT_EQ(picture["beside"][0]["results"], other);
  EXPECT_EQ(picture["beside"][0]["time"], 0.5);
  std::vector<std::string> five(5, results());
  five.insert(five.begin(), "render");
  five.insert(five.end(), {"--out", place("five.png")});
  EXPECT_EQ(talus_cli(five).exit_code, 2);
  EXPECT_EQ(talus_cli({"render", results(), place("none"), "--out", place("n.png")}).exit_code, 2);
}

TEST_F(Commands, AnimateWritesFilms) {
  for (const auto& [name, magic] : {std::pair("film.gif", "GIF89a"), std::pair("film.mp4", "ftyp")}) {
    const Ending ending = talus_cli({"animate", results(), "--out", place(name), "--size", "160x120", "--fps", "10",
                                     "--field", "velocity", "--json"});
    ASSERT_EQ(ending.exit_code, 0) << ending.err;
    EXPECT_EQ(Json::parse(ending.out)["frames"], 21);
    EXPECT_EQ(Json::parse(ending.out)["pictures"], 11) << "a second in real time, and the first picture";
    EXPECT_THAT(text_of(place(name)).substr(0, 12), HasSubstr(magic));
  }
}

TEST_F(Commands, AnimateFilmsResultsSideBySideAndOverEachOther) {
  const std::string other = place("elsewhere") + "/" + std::filesystem::path(results()).filename().string();
  std::filesystem::create_directories(place("elsewhere"));
  std::filesystem::copy(results(), other, std::filesystem::copy_options::recursive);
  const auto filmed = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"animate", results(), other, "--out", place("two.gif"), "--size", "200x80", "--fps", "5",
                               "--field", "velocity"});
    return talus_cli(more);
  };
  const Ending beside = filmed({});
  EXPECT_EQ(beside.exit_code, 0) << beside.err;
  EXPECT_THAT(beside.out, HasSubstr("6 pictures of 42 frames"));
  EXPECT_EQ(filmed({"--over"}).exit_code, 0);
  const Ending alone = talus_cli({"animate", results(), "--over", "--out", place("two.gif")});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_THAT(alone.err, HasSubstr("two results are drawn over each other"));
}

TEST_F(Commands, RenderDrawsTrailsAxesAndWhoSleeps) {
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--trails"}, {"--turning-axes"}, {"--field", "asleep"}}) {
    std::vector<std::string> command{"render", results(), "--out", place("drawn.png"), "--size", "200x120"};
    command.insert(command.end(), more.begin(), more.end());
    EXPECT_EQ(talus_cli(command).exit_code, 0) << more.front();
  }
  const Ending safety = talus_cli({"render", results(), "--out", place("s.png"), "--field", "stress.safety"});
  EXPECT_EQ(safety.exit_code, 2);
  EXPECT_THAT(safety.err, HasSubstr("no material has a strength"));
}

TEST_F(Commands, AnimateGoesAtTheSpeedAndTheWayThatItIsTold) {
  write_text(*folder / "keys.csv", "time,x,y,z,to x,to y,to z\n0,20,-20,5,0,0,0\n1,20,20,5,0,0,-4\n");
  const auto filmed = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"animate", results(), "--out", place("moved.gif"), "--size", "64x48", "--fps", "5"});
    return talus_cli(more);
  };
  EXPECT_THAT(filmed({}).out, HasSubstr("1.2 s, 6 pictures of 21 frames, real time"));
  EXPECT_THAT(filmed({"--speed", "0.5"}).out, HasSubstr("11 pictures of 21 frames, 1/2 of real time"));
  EXPECT_THAT(filmed({"--from", "0.4", "--to", "0.8"}).out, HasSubstr("3 pictures"));
  EXPECT_THAT(filmed({"--from", "0.8"}).out, HasSubstr("2 pictures"));
  const std::string name = Json::parse(talus_cli({"mesh", sample("free_fall"), "--json"}).out)["blocks"][0]["name"];
  for (const std::vector<std::string>& way : {std::vector<std::string>{"--turn", "90"},
                                              {"--follow", name},
                                              {"--camera", place("keys.csv")},
                                              {"--title", "Fall"}})
    EXPECT_EQ(filmed(way).exit_code, 0) << way[0];
  for (const std::vector<std::string>& way : {std::vector<std::string>{"--speed", "0"},
                                              {"--follow", "B9"},
                                              {"--camera", place("none.csv")},
                                              {"--speed", "1e-9"},
                                              {"--from", "2"},
                                              {"--from", "0.5", "--to", "0.4"}})
    EXPECT_EQ(filmed(way).exit_code, 2) << way[0];
}

TEST_F(Commands, PlotDrawsAChartOfEachQuantityOrOneSheet) {
  const Ending charts = talus_cli({"plot", results(), "--out", place("charts"), "--size", "640x400", "--json"});
  ASSERT_EQ(charts.exit_code, 0) << charts.err;
  EXPECT_EQ(png_size(place("charts/P1-displacement.png")), std::pair(640, 400));
  EXPECT_EQ(png_size(place("charts/P1-velocity.png")), std::pair(640, 400));
  const Ending sheet = talus_cli({"plot", results(), "--out", place("sheet.png"), "--size", "640x400"});
  ASSERT_EQ(sheet.exit_code, 0) << sheet.err;
  EXPECT_EQ(png_size(place("sheet.png")), std::pair(1280, 400));
}

TEST_F(Commands, PlotComparesWithPublishedEvents) {
  // z = −½gt²: up to 1.22625 m of fall, upside down as an event that grows, at 0.5 s
  write_text(*folder / "events.csv",
             "time,event,quantity,minus,reaches\n0.4,half way,P1.displacement.magnitude,,1.22625\n"
             "0.9,never,P1.displacement.x,,1\n");
  const Ending ending =
      talus_cli({"plot", results(), "--out", place("marked"), "--events", place("events.csv"), "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const Json result = Json::parse(ending.out);
  EXPECT_NEAR(result["events"][0]["computed"].get<double>(), 0.5, 1e-6);
  EXPECT_NEAR(result["events"][0]["value_at_published"].get<double>(), 0.7848, 1e-6);
  EXPECT_TRUE(result["events"][1]["computed"].is_null());
  EXPECT_EQ(result["in_published_order"], false);
}

TEST_F(Commands, ExportWritesFramesForOthers) {
  const Ending vtu = talus_cli({"export", results(), "--out", place("vtu"), "--as", "vtu", "--json"});
  ASSERT_EQ(vtu.exit_code, 0) << vtu.err;
  EXPECT_EQ(Json::parse(vtu.out)["frames"], 21);
  EXPECT_THAT(text_of(place("vtu/frame_00020.vtu")), HasSubstr("<VTKFile type=\"UnstructuredGrid\""));
  EXPECT_THAT(text_of(place("vtu/frames.pvd")), HasSubstr("timestep=\"0.05"));

  const Ending csv = talus_cli({"export", results(), "--out", place("csv"), "--as", "csv"});
  ASSERT_EQ(csv.exit_code, 0) << csv.err;
  const Json mesh = Json::parse(talus_cli({"mesh", sample("free_fall"), "--json"}).out);
  const std::string nodes = text_of(place("csv/nodes_00003.csv"));
  EXPECT_EQ(std::count(nodes.begin(), nodes.end(), '\n'), mesh["blocks"][0]["nodes"].get<int>() + 1);

  const Ending one = talus_cli({"export", results(), "--out", place("one"), "--as", "csv", "--time", "0.52"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_TRUE(std::filesystem::exists(place("one/contacts_00010.csv")));
  EXPECT_FALSE(std::filesystem::exists(place("one/contacts_00011.csv")));

  const Ending again = talus_cli({"export", results(), "--out", place("csv"), "--as", "csv"});
  EXPECT_EQ(again.exit_code, 2) << "a folder that is not empty is left alone";
}

TEST_F(Commands, ExportWritesShapes) {
  const Ending stl = talus_cli({"export", results(), "--out", place("stl"), "--as", "stl", "--json"});
  ASSERT_EQ(stl.exit_code, 0) << stl.err;
  EXPECT_EQ(Json::parse(stl.out)["file"], place("stl/frame_00020.stl")) << "the last frame";
  EXPECT_GT(std::filesystem::file_size(place("stl/frame_00020.stl")), 84u);
  const Ending film = talus_cli({"export", results(), "--out", place("fall.glb")});
  ASSERT_EQ(film.exit_code, 0) << film.err;
  EXPECT_THAT(text_of(place("fall.glb")), HasSubstr("\"path\":\"translation\""));
  const Ending still = talus_cli({"export", results(), "--out", place("gltf"), "--as", "gltf", "--frame", "3"});
  ASSERT_EQ(still.exit_code, 0) << still.err;
  EXPECT_EQ(text_of(place("gltf/frame_00003.glb")).substr(0, 4), "glTF");

  const Ending unknown = talus_cli({"export", results(), "--out", place("fall.obj")});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("the format is missing; say vtu, csv, stl or gltf"));
}

TEST_F(Commands, SolveTellsTheToleranceThatItSolvedTo) {
  Json project = Json::parse(text_of(sample("free_fall")));
  project["solver"]["tolerance"] = "draft";
  write_text(*folder / "draft.talus", project.dump());
  const Ending ending = talus_cli({"solve", place("draft.talus")});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, HasSubstr("tolerance draft"));
  EXPECT_EQ(Json::parse(text_of(place("draft.results/summary.json")))["tolerance"], 1e-3);
  const Ending opened = talus_cli({"info", place("draft.results")});
  EXPECT_THAT(opened.out, HasSubstr("tolerance draft"));
}

TEST_F(Commands, OldNamesOfOptionsAreStillRead) {
  const Ending ending = talus_cli({"verify", "--stability", "incline_1_degree_slides", "--nudge", "1", "--json"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  const Json scenes = Json::parse(ending.out)["scenes"];
  ASSERT_EQ(scenes.size(), 2U);
  EXPECT_EQ(scenes[1]["scene"], "incline_1_degree_slides+1");
  EXPECT_GE(scenes[0]["interpenetration"], 0);
  for (const char* option : {"--struggles", "--trouble"})
    EXPECT_EQ(talus_cli({"render", results(), "--out", place("t.png"), "--size", "80x60", option}).exit_code, 0);
}

TEST(Help, OfEveryCommandNamesItsOptions) {
  for (const char* command : {"mesh", "solve", "render", "animate", "plot", "verify", "info", "report", "export"}) {
    const Ending ending = talus_cli({command, "--help"});
    EXPECT_EQ(ending.exit_code, 0);
    EXPECT_THAT(ending.out, HasSubstr("--json")) << command;
    EXPECT_EQ(ending.err, "");
  }
  EXPECT_THAT(talus_cli({"--help"}).out, HasSubstr("Exit codes"));
}

TEST_F(Commands, VersionSaysWhatTheProgramWasBuiltFrom) {
  const std::string version = talus_cli({"--version"}).out;
  EXPECT_EQ(version.substr(0, 12), "talus-cli 0.");
  EXPECT_THAT(version, ContainsRegex("\nbuilt with Eigen 3[.].*, SuiteSparse 5[.].*, gmsh 4[.].*, VTK 9[.].*\n"));
  if (!std::filesystem::exists(TALUS_SOURCE_DIR "/.git")) return;
  EXPECT_THAT(version, ContainsRegex("\ncommit [0-9a-f]{10}(, with changes)?\n"));
}

}  // namespace
}  // namespace talus::test
