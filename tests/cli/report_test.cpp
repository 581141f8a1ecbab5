#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "process.hpp"
#include "support/xml_elements.hpp"

// The report of a run, and its histories as charts that documents take.
namespace talus::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The results of incline_slide, solved once for all tests.
class Report : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<Folder>();
    ASSERT_EQ(talus_cli({"solve", sample("incline_slide"), "--out", results()}).exit_code, 0);
  }
  static void TearDownTestSuite() { folder.reset(); }

  static std::string results() { return (*folder / "slide.results").string(); }
  static std::string place(const std::string& name) { return (*folder / name).string(); }
  /// The text of the HTML report of a results folder.
  static std::string report_of(const std::string& of) {
    const Ending ending = talus_cli({"report", of, "--out", place("r.html")});
    EXPECT_EQ(ending.exit_code, 0) << ending.err;
    return text_of(place("r.html"));
  }

  static std::unique_ptr<Folder> folder;
};

std::unique_ptr<Folder> Report::folder;

TEST_F(Report, AsHtmlSaysAllThatAReaderNeedsToBelieveTheRun) {
  const std::string html = report_of(results());
  EXPECT_NO_THROW(xml_elements(html));
  for (const char* text :
       {"<h1>Block that slides on an incline</h1>", "Solved by Talus 0.", "All 5 expectations are met.",
        "1 sliding on one plane", "<h2>The model</h2>", "<td>rock</td><td class=\"r\">2600</td>", "P1: velocity",
        "Monitors", "<h2>Contacts in the last frame</h2>", "<td class=\"r\">15.0</td>", "<h2>Energy</h2>",
        "shear contact", "friction or cohesion on J1", "Seconds by phase", "<h2>Where it was hard</h2>"})
    EXPECT_THAT(html, HasSubstr(text));
}

TEST_F(Report, AsPdfHoldsTheSame) {
  const Ending ending = talus_cli({"report", results(), "--out", place("r.pdf"), "--json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_EQ(nlohmann::json::parse(ending.out)["report"], place("r.pdf"));
  EXPECT_EQ(text_of(place("r.pdf")).substr(0, 5), "%PDF-");
  const std::string read = "pdftotext -layout " + place("r.pdf") + " " + place("r.txt") + " 2>/dev/null";
  if (std::system(read.c_str()) != 0) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  for (const char* text : {"Block that slides on an incline", "All 5", "P1.displacement.x", "P1: velocity", "Energy"})
    EXPECT_THAT(text_of(place("r.txt")), HasSubstr(text));
}

TEST_F(Report, OfAKilledRunWithoutItsProjectSaysSo) {
  const std::string killed = place("killed.results");
  std::filesystem::copy(results(), killed);
  std::filesystem::remove(killed + "/summary.json");
  std::filesystem::remove(killed + "/project.talus");
  const std::string html = report_of(killed);
  EXPECT_THAT(html, HasSubstr("Not finished: the run goes on or was killed."));
  EXPECT_THAT(html, HasSubstr("Materials and joints are not known here: "));
  EXPECT_THAT(html, HasSubstr("P1: displacement"));
  EXPECT_THAT(html, Not(HasSubstr("How it was solved")));
}

TEST_F(Report, ListsTheStrengthOfMaterials) {
  const std::string strong = place("strong.results"), project = strong + "/project.talus";
  std::filesystem::copy(results(), strong);
  EXPECT_THAT(report_of(strong), Not(HasSubstr("Materials: strength")));
  std::string text = text_of(project);
  text.insert(text.find("\"density\""), R"("strength": {"cohesion": 2.5e6, "friction_angle": 38}, )");
  std::ofstream(project) << text;
  const std::string html = report_of(strong);
  for (const char* of : {"Materials: strength after Mohr and Coulomb", "<td class=\"r\">38</td>",
                         "<td class=\"r\">2.5</td>", "to the envelope’s apex"})
    EXPECT_THAT(html, HasSubstr(of));
  const Ending info = talus_cli({"info", project, "--json", "--no-forecast"});
  ASSERT_EQ(info.exit_code, 0) << info.err;
  const auto strength = nlohmann::json::parse(info.out)["materials"][0]["strength"];
  EXPECT_EQ(strength, nlohmann::json({{"cohesion", 2.5e6}, {"friction_angle", 38}}));
  EXPECT_THAT(talus_cli({"info", project, "--no-forecast"}).out, HasSubstr("Strength of"));
}

TEST_F(Report, IsRefusedWithOneLineThatSaysWhatToDo) {
  const auto refused = [&](const std::string& of, const std::string& out, const std::string& what) {
    const Ending ending = talus_cli({"report", of, "--out", out});
    EXPECT_EQ(ending.exit_code, 2);
    EXPECT_EQ(std::ranges::count(ending.err, '\n'), 1) << ending.err;
    EXPECT_THAT(ending.err, HasSubstr(what));
    EXPECT_FALSE(std::filesystem::exists(out));
  };
  refused(results(), place("r.docx"), "r.docx: reports are written as HTML or PDF; let the name end in .html or .pdf");
  refused(place("none"), place("none.html"), "holds no results.h5");
  refused(results(), place("nowhere/r.html"), "nowhere/r.html: cannot be written");
}

TEST_F(Report, ChartsAreDrawnForDocumentsToo) {
  const Ending svg = talus_cli({"plot", results(), "--out", place("sheet.svg"), "--size", "640x400"});
  ASSERT_EQ(svg.exit_code, 0) << svg.err;
  const std::vector<std::string> elements = xml_elements(text_of(place("sheet.svg")));
  EXPECT_EQ(std::ranges::count(elements, "svg"), 3) << "the sheet and two charts";
  EXPECT_THAT(text_of(place("sheet.svg")), HasSubstr(">P1: velocity</text>"));
  const Ending pdf = talus_cli({"plot", results(), "--out", place("sheet.pdf")});
  ASSERT_EQ(pdf.exit_code, 0) << pdf.err;
  EXPECT_THAT(text_of(place("sheet.pdf")), HasSubstr("/Count 2")) << "a page a chart";
}

}  // namespace
}  // namespace talus::test
