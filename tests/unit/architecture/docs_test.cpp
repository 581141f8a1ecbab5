#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

// Docs that stay true: what they name is there, and their lines can be read side by side with the source.
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

const fs::path source_folder = TALUS_SOURCE_DIR;

struct Page {
  std::string path;  ///< from the source folder
  std::string text;
};

std::string text_at(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::vector<Page> pages() {
  std::vector<fs::path> paths{source_folder / "README.md", source_folder / "CHANGELOG.md"};
  for (const auto& entry : fs::recursive_directory_iterator(source_folder / "docs"))
    if (entry.path().extension() == ".md") paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<Page> pages;
  for (const fs::path& path : paths)
    pages.push_back({fs::relative(path, source_folder).generic_string(), text_at(path)});
  return pages;
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

/// Characters of a UTF-8 text.
std::size_t length(const std::string& text) {
  return std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
}

/// Lines of more than 120 characters; the rows of tables cannot be wrapped.
std::vector<std::string> long_lines(const Page& page) {
  std::vector<std::string> found;
  std::istringstream lines(page.text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
    if (length(line) > 120 && !line.starts_with('|')) found.push_back(page.path + ":" + std::to_string(number));
  return found;
}

/// Links to files that are not there.
std::vector<std::string> broken_links(const Page& page) {
  std::vector<std::string> found;
  for (const std::string& target : matches(page.text, R"(\]\(([^)#\s]+)(#[^)]*)?\))"))
    if (target.find("://") == std::string::npos &&
        !fs::exists(source_folder / fs::path(page.path).parent_path() / target))
      found.push_back(page.path + " links to " + target);
  return found;
}

/// Whether a path is there with its ending or without: "core/solve/simulation", "core/base/vector.hpp", "core/solve".
bool is_there(const fs::path& path) {
  return fs::exists(path) || fs::exists(path.string() + ".hpp") || fs::exists(path.string() + ".cpp");
}

/// Files and folders of the source in back quotes that are not there, from the source folder ("core/solve/simulation")
/// or as an #include has them ("solve/simulation").
std::vector<std::string> missing_files(const Page& page) {
  std::vector<std::string> found;
  for (const std::string& name : matches(page.text, "`([a-z_0-9]+(?:/[a-z_0-9]+)+(?:\\.[a-z]+)?)/?`")) {
    const std::string first = name.substr(0, name.find('/'));
    bool ours = false, there = false;
    for (const char* base : {"", "core", "ui", "app"}) {
      ours = ours || (fs::is_directory(source_folder / base / first) && first != "build");
      there = there || is_there(source_folder / base / name);
    }
    if (ours && !there) found.push_back(page.path + " names " + name);
  }
  return found;
}

/// "growth` | 1.5 |": how docs/tolerances.md begins the row of each member of a header with tolerances.
std::vector<std::string> rows_of_tolerances(const std::string& header) {
  const std::regex member("\\n  (?:double|int) (\\w+) = ([^;]+);");
  std::vector<std::string> rows;
  for (std::sregex_iterator match(header.begin(), header.end(), member), end; match != end; ++match)
    rows.push_back((*match)[1].str() + "` | " + (*match)[2].str() + " |");
  return rows;
}

template <class Check>
std::vector<std::string> faults_of_all(const Check& check) {
  std::vector<std::string> found;
  for (const Page& page : pages()) std::ranges::copy(check(page), std::back_inserter(found));
  return found;
}

TEST(Docs, HaveLinesOfAtMost120Characters) { EXPECT_THAT(faults_of_all(long_lines), IsEmpty()); }

TEST(Docs, LinkToWhatIsThere) { EXPECT_THAT(faults_of_all(broken_links), IsEmpty()); }

TEST(Docs, NameFilesThatAreThere) { EXPECT_THAT(faults_of_all(missing_files), IsEmpty()); }

TEST(Docs, HaveEveryToleranceWithItsValue) {
  const std::string page = text_at(source_folder / "docs/tolerances.md");
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(source_folder / "core/model")) {
    if (!entry.path().filename().string().ends_with("tolerances.hpp")) continue;
    for (const std::string& row : rows_of_tolerances(text_at(entry.path()))) {
      EXPECT_NE(page.find(row), std::string::npos) << row << ": run tools/measure_tolerances.py";
      ++count;
    }
  }
  EXPECT_GT(count, 30U);
}

// The checks above mean something only if they can fail.
TEST(Docs, FaultsAreFound) {
  EXPECT_THAT(long_lines({"p.md", std::string(240, 'a') + "\nshort\n|" + std::string(240, 'a') + "\n"}),
              ElementsAre("p.md:1"));
  std::string greek;
  for (int i = 0; i < 120; ++i) greek += "φ";
  EXPECT_THAT(long_lines({"p.md", greek}), IsEmpty());
  EXPECT_THAT(broken_links({"docs/p.md", "[a](manual.md#x) [b](none.md) ![c](https://debian.org)"}),
              ElementsAre("docs/p.md links to none.md"));
  EXPECT_THAT(missing_files({"p.md", "`core/base` `base/vector` `core/base/vector.hpp` `base/units.hpp` `runs/001`"}),
              IsEmpty());
  EXPECT_THAT(missing_files({"p.md", "`core/nowhere/file` and `base/nothing.hpp`"}),
              ElementsAre("p.md names core/nowhere/file", "p.md names base/nothing.hpp"));
  EXPECT_THAT(
      rows_of_tolerances("struct T {\n  /// Of h. Chosen.\n  double gap = 1e-3;\n  int limit = 10;  ///< –\n};\n"),
      ElementsAre("gap` | 1e-3 |", "limit` | 10 |"));
}

}  // namespace
