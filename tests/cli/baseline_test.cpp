#include <gmock/gmock.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "process.hpp"
#include "support/xml_elements.hpp"

// Pictures as tests by a list of how they are drawn: talus-cli baseline.
namespace talus::test {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class Baselines : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<Folder>();
    ASSERT_EQ(talus_cli({"solve", sample("free_fall"), "--out", place("a fall.results")}).exit_code, 0);
  }
  static void TearDownTestSuite() { folder.reset(); }

  void SetUp() override {
    std::filesystem::create_directory(place("baselines"));
    list(
        "# drawn again by each test\n"
        "\n"
        "fall.png      '../a fall.results' --field displacement --size 320x240   # at its end\n"
        "more/top.png  '../a fall.results' --view top --size 320x240 --title \"Not a # comment\"\n");
  }
  void TearDown() override { std::filesystem::remove_all(place("baselines")); }

  static std::string place(const std::string& name) { return (*folder / name).string(); }
  static void list(const std::string& text) { write_text(place("baselines/baselines.txt"), text); }
  /// `baseline WHAT` of the folder.
  static Ending baseline(const std::string& what, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"baseline", what, place("baselines")};
    if (what == "check") words.insert(words.end(), {"--out", place("differing")});
    words.insert(words.end(), more.begin(), more.end());
    return talus_cli(words);
  }

  static std::unique_ptr<Folder> folder;
};

std::unique_ptr<Folder> Baselines::folder;

TEST_F(Baselines, AreMadeByUpdateAndHeldByCheck) {
  const Ending made = baseline("update");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("fall.png: is now what was drawn\n"));
  const Ending same = baseline("check", {"--threshold", "1", "--junit", place("same.xml")});
  EXPECT_EQ(same.exit_code, 0) << same.out;
  EXPECT_THAT(same.out, HasSubstr("2 of 2 pictures are as their baselines\n"));
  EXPECT_FALSE(std::filesystem::exists(place("differing"))) << "nothing is left where nothing differs";
  EXPECT_THAT(text_of(place("same.xml")), HasSubstr("tests=\"2\" failures=\"0\""));
  // They are what render draws.
  EXPECT_EQ(talus_cli({"render", place("a fall.results"), "--field", "displacement", "--size", "320x240", "--out",
                       place("p.png"), "--compare", place("baselines/fall.png"), "--threshold", "1"})
                .exit_code,
            0);
}

TEST_F(Baselines, ThatDifferAreToldOneByOneAndLeaveTheirDifference) {
  ASSERT_EQ(baseline("update").exit_code, 0);
  list(
      "fall.png      '../a fall.results' --field displacement --size 320x240 --theme dark\n"
      "more/top.png  '../a fall.results' --view top --size 320x240 --title \"Not a # comment\"\n"
      "new.png       '../a fall.results' --size 320x240\n"
      "gone.png      ../gone.results --size 320x240\n");
  const Ending ending = baseline("check", {"--junit", place("other.xml"), "--json"});
  EXPECT_EQ(ending.exit_code, 1) << ending.err;
  const Json json = Json::parse(ending.out);
  EXPECT_EQ(json["same"], false);
  std::vector<bool> same;
  for (const Json& picture : json["pictures"]) same.push_back(picture["same"]);
  EXPECT_THAT(same, ElementsAre(false, true, false, false));
  EXPECT_LT(json["pictures"][0]["similarity"], 0.75);
  EXPECT_THAT(json["pictures"][2]["problem"], HasSubstr("make it the baseline by baseline update"));
  EXPECT_THAT(json["pictures"][3]["problem"], HasSubstr("gone.results"));
  EXPECT_EQ(text_of(place("differing/fall.difference.png")).substr(1, 3), "PNG");
  EXPECT_EQ(text_of(place("differing/new.png")).substr(1, 3), "PNG");
  EXPECT_FALSE(std::filesystem::exists(place("differing/more/top.png")));
  EXPECT_THAT(xml_elements(text_of(place("other.xml"))),
              ElementsAre("testsuites", "testsuite", "testcase", "failure", "testcase", "testcase", "failure",
                          "testcase", "failure"));
  EXPECT_THAT(text_of(place("other.xml")), HasSubstr("tests=\"4\" failures=\"3\""));
  EXPECT_EQ(baseline("check", {"--picture", "more/top.png"}).exit_code, 0) << "one alone";
}

TEST_F(Baselines, AreReplacedByUpdateOnlyWhereTheyDiffer) {
  ASSERT_EQ(baseline("update").exit_code, 0);
  const std::string fall = text_of(place("baselines/fall.png"));
  const auto kept = std::filesystem::last_write_time(place("baselines/more/top.png"));
  list(
      "fall.png      '../a fall.results' --field displacement --size 320x240 --theme dark\n"
      "more/top.png  '../a fall.results' --view top --size 320x240 --title \"Not a # comment\"\n");
  const Ending one = baseline("update", {"--picture", "more/top.png"});
  EXPECT_THAT(one.out, HasSubstr("top.png: stays as it is\n"));
  EXPECT_THAT(one.out, Not(HasSubstr("fall.png")));
  const Json json = Json::parse(baseline("update", {"--json"}).out);
  EXPECT_EQ(json["updated"], Json({place("baselines/fall.png")}));
  EXPECT_EQ(json["kept"], Json({place("baselines/more/top.png")}));
  EXPECT_NE(text_of(place("baselines/fall.png")), fall);
  EXPECT_EQ(std::filesystem::last_write_time(place("baselines/more/top.png")), kept);
  EXPECT_EQ(baseline("check").exit_code, 0);
}

TEST_F(Baselines, WithAFaultyListAreRefusedWithItsLine) {
  const auto refused = [](const std::string& text, const std::string& what) {
    list(text);
    for (const char* command : {"check", "update"}) {
      const Ending ending = baseline(command);
      EXPECT_EQ(ending.exit_code, 2) << text;
      EXPECT_EQ(std::ranges::count(ending.err, '\n'), 1) << ending.err;
      EXPECT_THAT(ending.err, HasSubstr(what));
    }
  };
  refused("# nothing\n", "baselines.txt: names no picture");
  refused("\na.png ../x.results --colour red\n", "baselines.txt: line 2: The following argument was not expected");
  refused("a.png\n", "line 1: RESULTS is required");
  refused("a.png x.results --size 10\n", "line 1: --size: write it WIDTHxHEIGHT");
  refused("../a.png x.results\n", "line 1: '../a.png' is no name of a picture in this folder");
  refused("a.jpg x.results\n", "line 1: 'a.jpg' is no name of a picture");
  refused("a.png x.results\na.png y.results\n", "line 2: there are two pictures of the name a.png");
  std::filesystem::remove(place("baselines/baselines.txt"));
  EXPECT_THAT(baseline("check").err, HasSubstr("baselines.txt: cannot be read; make this list"));
  EXPECT_EQ(talus_cli({"baseline"}).exit_code, 2);
  list("a.png x.results\n");
  EXPECT_THAT(baseline("check", {"--picture", "b.png"}).err,
              HasSubstr("--picture b.png: the list has no such picture"));
  const Ending none = baseline("update");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("x.results"));
}

}  // namespace
}  // namespace talus::test
