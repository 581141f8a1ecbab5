#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "process.hpp"

// What a slide came to, as the command line says it, against closed forms.
namespace talus::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// A block that has slid for a second down a plane that dips 30° to the east, with a friction of 15°.
class Measure : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<Folder>();
    ASSERT_EQ(talus_cli({"solve", sample("incline_slide"), "--out", results(), "-q"}).exit_code, 0);
  }
  static void TearDownTestSuite() { folder.reset(); }
  static std::string place(const std::string& name) { return (*folder / name).string(); }
  static std::string results() { return place("slide.results"); }

  static std::unique_ptr<Folder> folder;
};

std::unique_ptr<Folder> Measure::folder;

TEST_F(Measure, SaysTheWayOfABlockDownAPlane) {
  const Ending ending = talus_cli({"measure", results(), "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const Json slide = Json::parse(ending.out);
  EXPECT_EQ(slide["moved"]["blocks"].size(), 1u);
  EXPECT_NEAR(slide["moved"]["volume"].get<double>(), 0.5, 1e-9);
  EXPECT_NEAR(slide["forward"][0].get<double>(), 1, 1e-5) << "east";
  // u = a t² / 2 and v = a t cos 30° with a = 2.62858 m/s², one second after 0.02 s in which it is held up by inertia.
  const double way = 2.62858 / 2, in_plan = 1.13821;
  EXPECT_NEAR(slide["run_out"]["in_space"]["length"].get<double>(), way, 2e-3 * way);
  EXPECT_NEAR(slide["run_out"]["in_plan"]["length"].get<double>(), in_plan, 2e-3 * in_plan);
  EXPECT_NEAR(slide["run_out"]["front"].get<double>(), in_plan, 2e-3 * in_plan);
  EXPECT_NEAR(slide["centre"]["angle"].get<double>(), 30, 1e-3);
  EXPECT_NEAR(slide["front"].back()["velocity"].get<double>(), 2.27642, 2e-3 * 2.27642);
  // Of the deposit, which lies on the plane: its thickness of 0.5 m, seen from straight above, and the void below its
  // face that leans over, 0.5 m · 0.5 m · tan 30° / 2 in section.
  EXPECT_NEAR(slide["deposit"]["max_depth"].get<double>(), 0.5 / std::cos(M_PI / 6), 0.02);
  EXPECT_NEAR(slide["deposit"]["bulk"].get<double>(), 0.5 + 0.125 * std::tan(M_PI / 6), 3e-3);
}

TEST_F(Measure, IsAskedForAnotherMomentLengthAndDirection) {
  const auto measured = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"measure", results(), "--json"});
    return Json::parse(talus_cli(more).out);
  };
  EXPECT_EQ(measured({"--frame", "0"})["moved"]["blocks"].size(), 0u);
  EXPECT_EQ(measured({"--moved", "5"})["moved"]["blocks"].size(), 0u);
  EXPECT_NEAR(measured({"--direction", "0"})["run_out"]["front"].get<double>(), 0, 1e-5) << "north, across the slope";
  EXPECT_EQ(measured({"--cell", "0.1"})["deposit"]["cell"], 0.1);
}

TEST_F(Measure, WritesTablesAndPictures) {
  const Ending ending = talus_cli({"measure", results(), "--out", place("slide")});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, HasSubstr("travel angle"));
  EXPECT_THAT(text_of(*folder / "slide/front.csv"),
              StartsWith("time [s],advance [m],velocity [m/s],volume [m3]\n0,0,"));
  EXPECT_THAT(text_of(*folder / "slide/depth.asc"), StartsWith("ncols "));
  EXPECT_THAT(text_of(*folder / "slide/deposit.csv"), StartsWith("ring,x [m],y [m]\n0,"));
  for (const char* picture : {"deposit.png", "front.png"})
    EXPECT_THAT(text_of(*folder / (std::string("slide/") + picture)), StartsWith("\x89PNG")) << picture;
  EXPECT_EQ(talus_cli({"measure", results(), "--out", place("slide")}).exit_code, 2) << "a folder that holds something";
}

TEST_F(Measure, PlotTellsWhatBecameOfBlocks) {
  const auto plotted = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"plot", results(), "--block", "block"});
    return talus_cli(more);
  };
  ASSERT_EQ(plotted({"--out", place("b.csv"), "--quantity", "speed", "--quantity", "kinetic_energy"}).exit_code, 0);
  const std::string table = text_of(*folder / "b.csv");
  EXPECT_THAT(table, StartsWith("time [s],block.speed [m/s],block.kinetic_energy [J]\n0,0,0\n"));
  // v = a t down the dip, 2.62858 m/s after a second, of 0.5 m³ of 2600 kg/m³ rock.
  double time = 0, speed = 0, energy = 0;
  ASSERT_EQ(std::sscanf(table.c_str() + table.rfind('\n', table.size() - 2), "%lf,%lf,%lf", &time, &speed, &energy), 3);
  EXPECT_NEAR(speed, 2.62858, 5e-3);
  EXPECT_NEAR(energy, 0.5 * 1300 * speed * speed, 0.1);
  EXPECT_EQ(plotted({"--out", place("b.svg")}).exit_code, 0);
  EXPECT_THAT(text_of(*folder / "b.svg"), HasSubstr(">Rotation<"));
  EXPECT_EQ(plotted({"--out", place("charts"), "--quantity", "contact_force"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(*folder / "charts/blocks-contact_force.png"));

  EXPECT_THAT(plotted({"--out", place("c.png"), "--quantity", "weight"}).err, HasSubstr("there is no such quantity"));
  const Ending unknown = talus_cli({"plot", results(), "--out", place("c.png"), "--block", "B9"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("block B9: the results hold no block of that name"));
}

TEST_F(Measure, PlotFollowsAFieldAlongALine) {
  // Down through the middle of the block, where it is at rest in the first frame.
  const std::string through = "-0.308,0.01,3,-0.308,0.01,-3";
  const auto plotted = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"plot", results()});
    return talus_cli(more);
  };
  ASSERT_EQ(plotted({"--line", through, "--frame", "0", "--field", "stress.zz", "--out", place("l.csv")}).exit_code, 0);
  const std::string table = text_of(*folder / "l.csv");
  EXPECT_THAT(table, StartsWith("distance [m],x [m],y [m],z [m],block,stress.zz [Pa]\n"));
  EXPECT_THAT(table, HasSubstr(",block,"));
  EXPECT_THAT(table, HasSubstr(",slope,"));
  EXPECT_EQ(plotted({"--line", through, "--frame", "0", "--out", place("l.svg")}).exit_code, 0);
  EXPECT_THAT(text_of(*folder / "l.svg"), HasSubstr("Distance along the line (m)"));
  for (const char* line : {"1,2,3", "0,0,0,0,0,0", "90,0,0,91,0,0", "a,b,c,d,e,f"}) {
    const Ending ending = plotted({"--line", line, "--out", place("n.svg")});
    EXPECT_EQ(ending.exit_code, 2) << line;
    EXPECT_THAT(ending.err, HasSubstr("line")) << line;
  }
}

TEST_F(Measure, StereonetShowsTheJointsThatSlipped) {
  const Ending ending = talus_cli({"stereonet", results(), "--picture", place("net.svg"), "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const Json net = Json::parse(ending.out);
  EXPECT_EQ(net["poles"], 1);
  EXPECT_NEAR(net["sets"][0]["mean"]["dip"].get<double>(), 30, 1e-6);
  EXPECT_NEAR(net["sets"][0]["mean"]["dip_direction"].get<double>(), 90, 1e-6);
}

TEST_F(Measure, RefusesWhatIsNoLength) {
  for (const auto& [option, value] : {std::pair{"--moved", "-1"},
                                      {"--cell", "0"},
                                      {"--cell", "1e-7"},
                                      {"--direction", "nan"},
                                      {"--moved", "far"},
                                      {"--frame", "9999"}}) {
    const Ending ending = talus_cli({"measure", results(), option, value});
    EXPECT_EQ(ending.exit_code, 2) << option << ' ' << value;
    EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1) << ending.err;
  }
}

}  // namespace
}  // namespace talus::test
