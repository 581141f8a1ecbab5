#include <gmock/gmock.h>

#include <array>
#include <chrono>
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
  const Ending info = talus_cli({"info", project, "--json"});
  ASSERT_EQ(info.exit_code, 0) << info.err;
  const auto strength = nlohmann::json::parse(info.out)["materials"][0]["strength"];
  EXPECT_EQ(strength, nlohmann::json({{"cohesion", 2.5e6}, {"friction_angle", 38}}));
  EXPECT_THAT(talus_cli({"info", project}).out, HasSubstr("Strength of"));
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
  refused(place("none"), place("none.html"), "none: cannot be read: no such file");
  std::filesystem::create_directory(place("empty"));
  refused(place("empty"), place("none.html"), "holds no results.h5");
  refused(results(), place("nowhere/r.html"), "nowhere/r.html: cannot be written");
}

/// A project whose results are made and used by its reports.
class ReportOfAProject : public testing::Test {
 protected:
  ReportOfAProject() {
    write_text(project, R"({"talus": 1, "name": "A fall", "output": {"every": 0.05}, "default_joint": "J1",
  "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.24}}, "joints": {"J1": {"friction_angle": 30}},
  "solids": [{"name": "cube", "material": "rock", "body": "rigid", "file": "cube.stl"}],
  "stages": [{"name": "fall", "type": "dynamic", "time_step": 0.01, "duration": 0.1}]})");
    write_cube(1);
  }

  /// Of a tetrahedron with edges of `size` m along the axes.
  void write_cube(double size) {
    const std::string s = std::to_string(size);
    const std::string corners[] = {"0 0 0", s + " 0 0", "0 " + s + " 0", "0 0 " + s};
    std::string text = "solid cube\n";
    for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
      text += "facet normal 0 0 0\nouter loop\nvertex " + corners[a] + "\nvertex " + corners[b] + "\nvertex " +
              corners[c] + "\nendloop\nendfacet\n";
    write_text(folder / "cube.stl", text + "endsolid cube\n");
  }

  /// Makes the report; whether the project was solved for it.
  bool solves(const std::vector<std::string>& more = {}, const std::string& of = {}) {
    std::vector<std::string> words{"report", of.empty() ? project : of, "--out", html(), "--json"};
    words.insert(words.end(), more.begin(), more.end());
    std::filesystem::remove(html());
    said = talus_cli(words);
    EXPECT_EQ(said.exit_code, 0) << said.err;
    EXPECT_THAT(text_of(html()), HasSubstr("<h1>A fall</h1>"));
    return nlohmann::json::parse(said.out)["solved"];
  }

  void change(const std::string& from, const std::string& to) {
    std::string text = text_of(project);
    text.replace(text.find(from), from.size(), to);
    write_text(project, text);
  }

  std::string html() const { return (folder / "r.html").string(); }

  Folder folder;
  const std::string project = (folder / "fall.talus").string(), results = (folder / "fall.results").string();
  Ending said;
};

TEST_F(ReportOfAProject, IsMadeByOneCommandWhichSolvesItFirst) {
  EXPECT_TRUE(solves());
  EXPECT_EQ(nlohmann::json::parse(said.out)["results"], results);
  EXPECT_THAT(said.err, HasSubstr("Solves the project into " + results + ": there are no results yet"));
  const auto solved = std::filesystem::last_write_time(results + "/results.h5");
  EXPECT_FALSE(solves()) << "the results are there";
  EXPECT_THAT(said.err, HasSubstr("Takes the results in " + results));
  EXPECT_EQ(std::filesystem::last_write_time(results + "/results.h5"), solved);
  EXPECT_TRUE(solves({"--anew"}));
  EXPECT_NE(std::filesystem::last_write_time(results + "/results.h5"), solved);
  EXPECT_TRUE(solves({"--results", (folder / "elsewhere").string()}));
  EXPECT_TRUE(std::filesystem::exists(folder / "elsewhere" / "summary.json"));
}

TEST_F(ReportOfAProject, TakesNoResultsOfAnotherProject) {
  EXPECT_TRUE(solves());
  change("A fall\"", "A fall\" /* the same */");
  EXPECT_FALSE(solves()) << "a comment changes nothing";
  change("2600", "2700");
  EXPECT_TRUE(solves());
  EXPECT_THAT(said.err, HasSubstr("the project is not that of the results that were there"));
  EXPECT_THAT(text_of(html()), HasSubstr("<td class=\"r\">2700</td>"));
  EXPECT_FALSE(solves());
  write_cube(2);
  std::filesystem::last_write_time(folder / "cube.stl",
                                   std::filesystem::file_time_type::clock::now() + std::chrono::seconds(1));
  EXPECT_TRUE(solves());
  EXPECT_THAT(said.err, HasSubstr("a file that the project names is newer"));
  change("\"duration\": 0.1", "\"duration\": 0.2");
  EXPECT_TRUE(solves());
}

TEST_F(ReportOfAProject, GoesOnWithARunThatWasStopped) {
  EXPECT_EQ(talus_cli({"solve", project, "--max-wall", "0"}).exit_code, 1);
  ASSERT_TRUE(std::filesystem::exists(results + "/checkpoint.h5"));
  EXPECT_TRUE(solves());
  EXPECT_THAT(said.err, HasSubstr("its run did not come to its end"));
  EXPECT_THAT(said.err, HasSubstr("Goes on at t = "));
  EXPECT_FALSE(solves());
}

TEST_F(ReportOfAProject, EndsWithOneWhereTheRunFellShort) {
  change("\"output\"", R"("expect": [{"quantity": "cube.displacement.z", "time": 0.1, "value": 1, "tolerance": 0.01}],
  "output")");
  for (const bool again : {false, true}) {
    const Ending ending = talus_cli({"report", project, "--out", html()});
    EXPECT_EQ(ending.exit_code, 1) << again;
    EXPECT_THAT(ending.err, HasSubstr("1 of 1 expectations are missed"));
    EXPECT_THAT(text_of(html()), HasSubstr("<h1>A fall</h1>"));
  }
}

TEST_F(ReportOfAProject, IsRefusedInItsOwnWords) {
  const auto refused = [&](const std::vector<std::string>& words, const std::string& what) {
    std::vector<std::string> all{"report"};
    all.insert(all.end(), words.begin(), words.end());
    const Ending ending = talus_cli(all);
    EXPECT_EQ(ending.exit_code, 2) << ending.err;
    EXPECT_THAT(ending.err, HasSubstr(what));
    EXPECT_FALSE(std::filesystem::exists(html()));
  };
  refused({project, "--out", (folder / "r.docx").string()}, "let the name end in .html or .pdf");
  EXPECT_FALSE(std::filesystem::exists(results)) << "before anything is solved";
  refused({"-", "--out", html()}, "--results: standard input has no name");
  refused({project, "--out", html(), "--results", folder.path().string()},
          "holds files that are not results; choose another --results");
  EXPECT_EQ(talus_cli({"solve", project}).exit_code, 0);
  refused({results, "--out", html(), "--anew"}, "leave --results and --anew out, or name the project");
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
