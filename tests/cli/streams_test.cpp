#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "process.hpp"

// Projects from standard input; what goes to standard error, on a terminal and elsewhere.
namespace talus::test {
namespace {

using Json = nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(StandardInput, GivesTheProjectToEveryCommandThatReadsOne) {
  const std::string project = sample("free_fall");
  for (const char* command : {"info", "mesh", "blocks", "inspect"}) {
    std::vector<std::string> words{command, "-", "--json"};
    const Ending ending = talus_cli(words, project);
    EXPECT_EQ(ending.exit_code, 0) << command << ": " << ending.err;
    words[1] = project;
    EXPECT_EQ(ending.out, talus_cli(words).out) << command;
  }
}

TEST(StandardInput, IsSolvedAsTheFileIs) {
  const Folder folder;
  const auto from_input = folder / "a", from_file = folder / "b";
  EXPECT_EQ(talus_cli({"solve", "-", "--out", from_input.string()}, sample("free_fall")).exit_code, 0);
  EXPECT_EQ(talus_cli({"solve", sample("free_fall"), "--out", from_file.string()}).exit_code, 0);
  for (const char* file : {"history.csv", "project.talus"})
    EXPECT_EQ(text_of(from_input / file), text_of(from_file / file)) << file;
}

TEST(StandardInput, HasNoNameForAResultsFolder) {
  const Ending ending = talus_cli({"solve", "-"}, sample("free_fall"));
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_THAT(ending.err, StartsWith("talus-cli: --out: standard input has no name"));
  EXPECT_EQ(talus_cli({"study", "accuracy", "-"}, sample("free_fall")).exit_code, 2);
}

TEST(StandardInput, IsWhatErrorsName) {
  const Folder folder;
  write_text(folder / "bad", "{ \"talus\": 1,\n  \"name\" \"x\" }\n");
  EXPECT_THAT(talus_cli({"info", "-"}, folder / "bad").err, StartsWith("talus-cli: standard input: line 2"));
  EXPECT_EQ(talus_cli({"info", "-"}).exit_code, 2) << "nothing is no project";
}

TEST(StandardInput, NamesFilesFromTheWorkingFolder) {
  const Folder folder;
  const std::string slope = std::filesystem::path(sample("step_slope")).parent_path().string();
  const auto inspect_in = [&](const std::string& place) {
    const std::string command = "cd " + place + " && " TALUS_CLI " inspect - < " + sample("step_slope") + " > " +
                                (folder / "out").string() + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  };
  EXPECT_EQ(inspect_in(slope), 0) << text_of(folder / "out");
  EXPECT_EQ(inspect_in(folder.path().string()), 2) << "slope.step is not there";
}

TEST(StandardInput, HoldsAProjectOrATableOfJointsForAStereonet) {
  const Folder folder;
  write_text(folder / "table", "dip,dip direction\n45,120\n50,130\n");
  EXPECT_EQ(Json::parse(talus_cli({"stereonet", "-", "--json"}, folder / "table").out)["poles"], 2);
  EXPECT_EQ(talus_cli({"stereonet", "-", "--json"}, sample("step_slope")).out,
            talus_cli({"stereonet", sample("step_slope"), "--json"}).out);
}

/// Free fall for so long that it takes about the two seconds after which a log is told, 6000 steps.
TEST(StandardError, InALogHasALineATenthOfTheWayAtMost) {
  const Folder folder;
  Json project = Json::parse(text_of(sample("free_fall")));
  project["stages"][0]["duration"] = 60;
  project.erase("expect");
  write_text(folder / "long.talus", project.dump());
  const Ending told = talus_cli({"solve", (folder / "long.talus").string()});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_LE(std::ranges::count(told.err, '\n'), 11) << told.err;
  EXPECT_THAT(told.err, Not(HasSubstr("\r")));
}

TEST(StandardError, OfAQuietCommandHasErrorsAlone) {
  const Folder folder;
  const Ending quiet = talus_cli({"solve", sample("free_fall"), "--out", (folder / "r").string(), "--quiet"});
  EXPECT_EQ(quiet.err, "");
  EXPECT_THAT(quiet.out, HasSubstr("completed")) << "what was asked for is printed";
  EXPECT_THAT(talus_cli({"solve", (folder / "none.talus").string(), "-q"}).err, HasSubstr("no such file"));
}

/// What a terminal of 80 columns is sent.
std::string sent_to_terminal(const std::string& arguments, const std::string& kind) {
  const Folder folder;
  const std::string command = "TERM=" + kind + " NO_COLOR=1 script --quiet --return --command '" TALUS_CLI " " +
                              arguments + "' /dev/null > " + (folder / "sent").string();
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0);
  return text_of(folder / "sent");
}

TEST(StandardError, OnATerminalDrawsOneLineAnewAndNoColours) {
  const std::string command = "blocks " + sample("step_slope");
  const std::string sent = sent_to_terminal(command, "xterm");
  EXPECT_THAT(sent, HasSubstr("\r\x1b[K█"));
  EXPECT_THAT(sent, Not(ContainsRegex("\x1b\\[[0-9;]*m"))) << "colour";
  EXPECT_EQ(sent.find('\n'), sent.find("\r\n") + 1) << "the bar is gone before the table";
  EXPECT_THAT(sent_to_terminal(command, "dumb"), Not(HasSubstr("\x1b")));
  EXPECT_THAT(sent_to_terminal(command + " --quiet", "xterm"), Not(HasSubstr("\x1b")));
  EXPECT_THAT(talus_cli({"blocks", sample("step_slope")}).err, Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace talus::test
