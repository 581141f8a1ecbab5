#include <gmock/gmock.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "process.hpp"
#include "support/xml_elements.hpp"

// Pictures as tests: talus-cli render --compare.
namespace talus::test {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

class Compare : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<Folder>();
    ASSERT_EQ(talus_cli({"solve", sample("free_fall"), "--out", results()}).exit_code, 0);
    ASSERT_EQ(drawn({"--update"}).exit_code, 0);
  }
  static void TearDownTestSuite() { folder.reset(); }

  static std::string results() { return (*folder / "fall.results").string(); }
  static std::string place(const std::string& name) { return (*folder / name).string(); }
  /// Draws p.png and compares it with right.png.
  static Ending drawn(std::vector<std::string> more, const std::string& baseline = "right.png") {
    std::vector<std::string> words{"render",  results(), "--out",        place("p.png"), "--size",
                                   "320x240", "--field", "displacement", "--compare",    place(baseline)};
    words.insert(words.end(), more.begin(), more.end());
    return talus_cli(words);
  }

  static std::unique_ptr<Folder> folder;
};

std::unique_ptr<Folder> Compare::folder;

TEST_F(Compare, TheSamePictureIsTheSameAndLeavesNoDifference) {
  write_text(place("p.difference.png"), "of an earlier call");
  const Ending ending = drawn({"--threshold", "1", "--junit", place("same.xml")});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, HasSubstr("right.png: similarity 1.000, at least 1.000 is asked for\n"));
  EXPECT_FALSE(std::filesystem::exists(place("p.difference.png")));
  EXPECT_THAT(xml_elements(text_of(place("same.xml"))), ElementsAre("testsuites", "testsuite", "testcase"));
  EXPECT_THAT(text_of(place("same.xml")), HasSubstr("tests=\"1\" failures=\"0\""));
}

TEST_F(Compare, AnotherPictureEndsWithOneAndSaysHowMuchAndWhere) {
  const Ending ending = drawn({"--view", "iso", "--frame", "3", "--junit", place("other.xml")});
  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_EQ(std::ranges::count(ending.out, '\n'), 2) << "the frame, and the difference: " << ending.out;
  EXPECT_THAT(ending.out, HasSubstr("p.png differs from "));
  EXPECT_THAT(ending.out, testing::ContainsRegex("worst in the 16 × 16 pixels at [0-9]+,[0-9]+; "));
  EXPECT_EQ(text_of(place("p.difference.png")).substr(1, 3), "PNG");
  EXPECT_THAT(xml_elements(text_of(place("other.xml"))), ElementsAre("testsuites", "testsuite", "testcase", "failure"));
  EXPECT_THAT(text_of(place("other.xml")), HasSubstr("name=\"right.png\""));
}

TEST_F(Compare, JsonHoldsTheSame) {
  const Ending other = drawn({"--theme", "dark", "--json"});
  EXPECT_EQ(other.exit_code, 1);
  const Json json = Json::parse(other.out);
  EXPECT_EQ(json["same"], false);
  EXPECT_EQ(json["threshold"], 0.75);
  EXPECT_LT(json["similarity"], 0.75);
  EXPECT_EQ(json["worst"]["width"], 16);
  EXPECT_EQ(json["region"]["width"], 320);
  EXPECT_EQ(json["difference_picture"], place("p.difference.png"));
  const Json same = Json::parse(drawn({"--json"}).out);
  EXPECT_EQ(same["same"], true);
  EXPECT_EQ(same["similarity"], 1.0);
}

TEST_F(Compare, TheThresholdDecides) { EXPECT_EQ(drawn({"--theme", "dark", "--threshold", "0"}).exit_code, 0); }

TEST_F(Compare, AnotherSizeIsTold) {
  const Ending ending = talus_cli({"render", results(), "--out", place("small.png"), "--size", "200x150", "--compare",
                                   place("right.png"), "--junit", place("size.xml")});
  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_THAT(ending.out,
              HasSubstr("it has 200 × 150 pixels, the baseline 320 × 240 pixels; draw with --size 320x240"));
  EXPECT_THAT(text_of(place("size.xml")), HasSubstr("failures=\"1\""));
}

TEST_F(Compare, WithoutABaselineItSaysHowToMakeOne) {
  const Ending ending = drawn({"--junit", place("none.xml")}, "none.png");
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_THAT(ending.err, HasSubstr("none.png: there is no such baseline; look at " + place("p.png")));
  EXPECT_THAT(ending.err, HasSubstr("--update"));
  EXPECT_THAT(text_of(place("none.xml")), HasSubstr("failures=\"1\""));
  EXPECT_FALSE(std::filesystem::exists(place("none.png")));
}

TEST_F(Compare, UpdateReplacesTheBaseline) {
  ASSERT_EQ(drawn({"--update"}, "mine.png").exit_code, 0);
  const std::string before = text_of(place("mine.png"));
  EXPECT_EQ(drawn({"--theme", "dark", "--update"}, "mine.png").exit_code, 0);
  EXPECT_NE(text_of(place("mine.png")), before);
  EXPECT_EQ(drawn({"--theme", "dark"}, "mine.png").exit_code, 0);
}

TEST_F(Compare, NeverDrawsOverItsBaseline) {
  const std::string before = text_of(place("right.png"));
  const Ending ending = talus_cli({"render", results(), "--out", place("right.png"), "--compare",
                                   place("fall.results/../right.png"), "--theme", "dark"});
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_THAT(ending.err, HasSubstr("is the picture to draw, too; give --out another name"));
  EXPECT_EQ(text_of(place("right.png")), before);
}

TEST_F(Compare, WhatIsNoPictureIsRefused) {
  write_text(place("text.png"), "no picture");
  const Ending ending = drawn({}, "text.png");
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_THAT(ending.err, HasSubstr("text.png: no readable PNG"));
}

}  // namespace
}  // namespace talus::test
