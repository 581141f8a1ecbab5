#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

// Two classes of one name in one namespace link without a word, and one's destructor runs on the other's objects.
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

/// Classes that a header defines at the top of its namespace, with the namespace before them.
std::set<std::string> classes_in(const std::string& text) {
  static const std::regex namespace_line("^namespace (\\S+) \\{", std::regex::multiline);
  static const std::regex class_line("^(struct|class|enum class) (\\w+)( final)?( : [^;{]*)? ?\\{",
                                     std::regex::multiline);
  std::smatch found;
  const std::string where = std::regex_search(text, found, namespace_line) ? found[1].str() : std::string();
  std::set<std::string> names;
  for (std::sregex_iterator match(text.begin(), text.end(), class_line), end; match != end; ++match)
    names.insert(where + "::" + (*match)[2].str());
  return names;
}

/// "talus::Scene: a.hpp b.hpp", for every name that more than one header defines.
std::set<std::string> repeated_names(const std::map<std::string, std::string>& texts) {
  std::map<std::string, std::string> places;
  std::set<std::string> repeated;
  for (const auto& [path, text] : texts)
    for (const std::string& name : classes_in(text)) {
      std::string& where = places[name];
      if (!where.empty()) repeated.insert(name);
      where += ' ' + path;
    }
  std::set<std::string> lines;
  for (const std::string& name : repeated) lines.insert(name + ':' + places[name]);
  return lines;
}

TEST(Names, OfClassesAreThereOnceInAllHeaders) {
  const fs::path root = TALUS_SOURCE_DIR;
  std::map<std::string, std::string> texts;
  for (const char* part : {"core", "ui", "app"})
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      if (entry.path().extension() != ".hpp") continue;
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      texts[fs::relative(entry.path(), root).generic_string()] = text.str();
    }
  ASSERT_GT(texts.size(), 15U);
  EXPECT_THAT(repeated_names(texts), IsEmpty());
}

TEST(Names, ThatTwoHeadersGiveAreFound) {
  const std::string scene = "namespace talus {\n\nstruct Scene {\n};\n",
                    other = "namespace talus {\nclass Scene final {\n";
  EXPECT_THAT(repeated_names({{"a.hpp", scene}, {"b.hpp", other}}), testing::ElementsAre("talus::Scene: a.hpp b.hpp"));
  EXPECT_THAT(repeated_names({{"a.hpp", scene}, {"b.hpp", "namespace talus::cli {\nclass Scene {\n"}}), IsEmpty());
  EXPECT_THAT(repeated_names({{"a.hpp", scene}, {"b.hpp", "namespace talus {\nclass Scene;\n"}}), IsEmpty());
}

}  // namespace
