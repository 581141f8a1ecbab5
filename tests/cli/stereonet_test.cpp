#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "process.hpp"
#include "support/xml_elements.hpp"

// Joint tables and projects on a stereonet.
namespace talus::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class StereonetCommand : public testing::Test {
 protected:
  std::string table(const std::string& text) {
    const auto file = folder / "joints.csv";
    write_text(file, text);
    return file.string();
  }
  Folder folder;
};

constexpr const char* hoek_and_bray = "dip;dip direction;set\n45;105;A\n70;235;B\n";

TEST_F(StereonetCommand, CountsWhatCanFailInAFace) {
  // Hoek & Bray's wedge: its line plunges 31.2°, and daylights in the face 65/185.
  const Ending ending =
      talus_cli({"stereonet", table(hoek_and_bray), "--face", "65/185", "--friction", "30", "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const Json found = Json::parse(ending.out);
  EXPECT_EQ(found["poles"], 2);
  EXPECT_EQ(found["sets"][1]["set"], "B");
  EXPECT_NEAR(found["sets"][1]["mean"]["dip_direction"].get<double>(), 235, 1e-9);
  EXPECT_TRUE(found["sets"][0]["kappa"].is_null());
  EXPECT_EQ(found["kinematics"]["wedge"]["critical"], 1);
  EXPECT_EQ(found["kinematics"]["wedge"]["percent"], 100);
  EXPECT_EQ(found["kinematics"]["planar"]["critical"], 0);
}

TEST_F(StereonetCommand, PrintsTablesForPeople) {
  const Ending ending = talus_cli(
      {"stereonet", table("40,100,A\n50,100,A\n45,280,B\n"), "--face", "65/100", "--window", "30..60/90..110"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, HasSubstr("Fisher κ"));
  EXPECT_THAT(ending.out, testing::ContainsRegex("A +2 +45.0 +100.0 +131"));  // 1/(2 − 2 cos 5°) = 131.4
  EXPECT_THAT(ending.out, HasSubstr("In the window"));
  EXPECT_THAT(ending.out, testing::ContainsRegex("planar sliding +2 +3 +66.67"));
}

TEST_F(StereonetCommand, DrawsAPictureAndWritesTheTable) {
  const std::string picture = (folder / "net.png").string(), out = (folder / "out.csv").string();
  const Ending ending = talus_cli({"stereonet", table(hoek_and_bray), "--density", "kamb", "--projection", "angle",
                                   "--picture", picture, "--size", "800x500", "--table", out});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_GT(std::filesystem::file_size(picture), 5000U);
  EXPECT_EQ(text_of(out), "dip [°],dip direction [°],set\n45,105,A\n70,235,B\n");
}

TEST_F(StereonetCommand, DrawsForDocumentsToo) {
  const auto draw = [&](const std::string& name) {
    return talus_cli({"stereonet", table(hoek_and_bray), "--picture", (folder / name).string()});
  };
  ASSERT_EQ(draw("net.svg").exit_code, 0);
  EXPECT_THAT(xml_elements(text_of(folder / "net.svg")), testing::Contains("polyline"));
  EXPECT_THAT(text_of(folder / "net.svg"), HasSubstr(">Sets</text>"));
  ASSERT_EQ(draw("net.pdf").exit_code, 0);
  EXPECT_THAT(text_of(folder / "net.pdf"), testing::StartsWith("%PDF-"));
  const Ending refused = draw("net.jpg");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("pictures are written as PNG, SVG or PDF; let the name end in"));
}

TEST_F(StereonetCommand, TakesTheCutsOfAProject) {
  const Ending ending = talus_cli({"stereonet", sample("step_slope"), "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_GT(Json::parse(ending.out)["poles"], 0);
}

TEST_F(StereonetCommand, RefusesWhatIsNoTableWithLineAndColumn) {
  const Ending ending = talus_cli({"stereonet", table("dip,dip direction\n45,10\n95,10\n")});
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_THAT(ending.err, HasSubstr("joints.csv: line 3, column dip: 95 is out of range; give degrees from 0 to 90"));
}

TEST_F(StereonetCommand, RefusesAFaceOrAWindowThatIsNone) {
  const std::string joints = table(hoek_and_bray);
  EXPECT_THAT(talus_cli({"stereonet", joints, "--face", "95/10"}).err, HasSubstr("--face: \"95/10\""));
  EXPECT_THAT(talus_cli({"stereonet", joints, "--window", "5/5~1"}).err, HasSubstr("--window: no pole lies in it"));
  EXPECT_EQ(talus_cli({"stereonet", joints, "--friction", "95"}).exit_code, 2);
}

}  // namespace
}  // namespace talus::test
