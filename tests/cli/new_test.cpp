#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "process.hpp"

// Beginning a project from a template.
namespace talus::test {
namespace {

using NewJson = nlohmann::json;
using testing::HasSubstr;

TEST(New, WritesAProjectThatIsCutAndMeshed) {
  const Folder folder;
  const std::string file = (folder / "toe.talus").string();
  const Ending made = talus_cli({"new", "column", "--height", "2", "--friction", "25", file});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.out, "wrote " + file + '\n');
  EXPECT_EQ(NewJson::parse(text_of(file))["joints"]["J1"]["friction_angle"], 25);
  const Ending meshed = talus_cli({"mesh", file, "--json"});
  EXPECT_EQ(meshed.exit_code, 0) << meshed.err;
  EXPECT_EQ(NewJson::parse(meshed.out)["blocks"].size(), 2U);
}

TEST(New, GivesTheFileItsEndingAndReplacesNothingUnasked) {
  const Folder folder;
  const std::string name = (folder / "face").string();
  EXPECT_EQ(talus_cli({"new", "toppling-face", name}).exit_code, 0);
  const std::string before = text_of(folder / "face.talus");
  const Ending again = talus_cli({"new", "wedge", name});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.err, HasSubstr("face.talus: is there already; choose another name, or replace it with --force"));
  EXPECT_EQ(text_of(folder / "face.talus"), before);
  EXPECT_EQ(talus_cli({"new", "wedge", name, "--force"}).exit_code, 0);
  EXPECT_NE(text_of(folder / "face.talus"), before);
}

TEST(New, SaysWhichNumberIsWrongAndWhatItMayBe) {
  const Folder folder;
  const std::string file = (folder / "wedge.talus").string();
  const Ending wide = talus_cli({"new", "wedge", "--plunge", "70", file});
  EXPECT_EQ(wide.exit_code, 2);
  EXPECT_THAT(wide.err, HasSubstr("Plunge ψ: must be 20 to 50 °, is 70"));
  EXPECT_FALSE(std::filesystem::exists(file));
  const Ending word = talus_cli({"new", "wedge", "--plunge", "steep", file});
  EXPECT_EQ(word.exit_code, 2);
  EXPECT_THAT(word.err, HasSubstr("--plunge"));
  const Ending none = talus_cli({"new", "wege", file});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("see talus-cli new --help"));
  EXPECT_EQ(talus_cli({"new"}).exit_code, 2);
}

TEST(New, ListsTemplatesWithNumbersUnitsAndRanges) {
  const Ending list = talus_cli({"new", "--list"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_THAT(list.out, HasSubstr("dry-stone-wall: "));
  EXPECT_THAT(list.out, HasSubstr("--face-angle"));
  EXPECT_THAT(list.out, HasSubstr("20 to 50 °"));
  const Ending json = talus_cli({"new", "--list", "--json"});
  const NewJson templates = NewJson::parse(json.out)["templates"];
  EXPECT_EQ(templates.size(), 7U);
  EXPECT_EQ(templates[0]["numbers"].size(), 5U);
  const Ending help = talus_cli({"new", "wedge", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, HasSubstr("--wedge-angle °"));
}

}  // namespace
}  // namespace talus::test
