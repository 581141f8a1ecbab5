#include <gmock/gmock.h>

#include <cstdlib>
#include <sstream>

#include "process.hpp"

// What `completion` prints, as a shell takes it.
namespace talus::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// What bash offers for the last of the words of a command line.
class BashCompletion : public testing::Test {
 protected:
  std::vector<std::string> offered(const std::string& words) {
    const auto script = folder_ / "completion.bash", out = folder_ / "out";
    write_text(script, talus_cli({"completion", "bash"}).out + "COMP_WORDS=(talus-cli " + words +
                           ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
                           "_talus_cli; for word in \"${COMPREPLY[@]}\"; do echo \"$word\"; done\n");
    EXPECT_EQ(std::system(("bash -u " + script.string() + " > " + out.string()).c_str()), 0);
    std::istringstream lines(text_of(out));
    std::vector<std::string> found;
    for (std::string line; std::getline(lines, line);) found.push_back(line);
    return found;
  }

 private:
  Folder folder_;
};

TEST_F(BashCompletion, OffersCommandsAndTheirParts) {
  EXPECT_THAT(offered("so"), ElementsAre("solve"));
  EXPECT_THAT(offered("''"),
              AllOf(Contains("new"), Contains("verify"), Contains("completion"), Not(Contains("--help"))));
  EXPECT_THAT(offered("new wed"), ElementsAre("wedge"));
  EXPECT_THAT(offered("study ''"), ElementsAre("accuracy", "cases")) << "and not the hidden run";
  EXPECT_THAT(offered("baseline ''"), ElementsAre("check", "update"));
}

TEST_F(BashCompletion, OffersTheOptionsOfACommand) {
  EXPECT_THAT(offered("--v"), ElementsAre("--version"));
  EXPECT_THAT(offered("solve --thr"), ElementsAre("--threads"));
  EXPECT_THAT(offered("new wedge x.talus --plu"), ElementsAre("--plunge"));
  EXPECT_THAT(offered("render --threads"), IsEmpty());
}

TEST_F(BashCompletion, OffersTheWordsThatAnOptionTakes) {
  EXPECT_THAT(offered("render slope.results --theme ''"), ElementsAre("light", "dark"));
  EXPECT_THAT(offered("verify --tolerance ''"), ElementsAre("draft", "standard", "reference"));
  EXPECT_THAT(offered("render --out ''"), IsEmpty()) << "bash offers files then";
}

TEST(Completion, OfEveryShellKnowsCommandsOptionsAndTheirWords) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const Ending ending = talus_cli({"completion", shell});
    EXPECT_EQ(ending.exit_code, 0) << ending.err;
    for (const char* word : {"talus-cli new dry-stone-wall", "allow-outside", "light dark", "fisher kamb", "sbatch"})
      EXPECT_THAT(ending.out, HasSubstr(word)) << shell;
  }
  EXPECT_EQ(talus_cli({"completion", "csh"}).exit_code, 2);
}

}  // namespace
}  // namespace talus::test
