#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/project_file.hpp"

// What docs/manual.md shows of a project file must be what the program reads.
namespace talus {
namespace {

using Json = nlohmann::ordered_json;

/// The indented passages of the part about project files, each without its indent.
std::vector<std::string> examples() {
  std::ifstream manual(TALUS_SOURCE_DIR "/docs/manual.md");
  std::vector<std::string> passages{""};
  bool inside = false;
  for (std::string line; std::getline(manual, line);) {
    if (line.starts_with("## ")) inside = line == "## Project files";
    if (inside && line.starts_with("    "))
      passages.back() += line + '\n';
    else if (!passages.back().empty())
      passages.emplace_back();
  }
  passages.pop_back();
  return passages;
}

TEST(ManualExamples, AreProjects) {
  const auto passages = examples();
  ASSERT_GE(passages.size(), 6u);
  const Json whole = Json::parse(passages[0]);
  EXPECT_NO_THROW(parse_project(passages[0]));
  for (std::size_t i = 1; i < passages.size(); ++i) {
    Json project = whole;
    project.update(Json::parse("{" + passages[i] + "}"));
    EXPECT_NE(project, whole) << passages[i];
    EXPECT_NO_THROW(parse_project(project.dump())) << passages[i];
  }
}

}  // namespace
}  // namespace talus
