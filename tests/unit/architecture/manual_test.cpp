#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// docs/manual.md is the reference of project files: what the schema lets a project say must stand there.
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(std::string(TALUS_SOURCE_DIR) + "/" + path).rdbuf();
  return text.str();
}

/// The names of all fields below a part of the schema.
std::set<std::string> fields_of(const nlohmann::json& schema) {
  std::set<std::string> fields;
  if (schema.is_object() && schema.contains("properties"))
    for (const auto& [name, meaning] : schema["properties"].items()) fields.insert(name);
  for (const auto& part : schema)
    if (part.is_structured()) fields.merge(fields_of(part));
  return fields;
}

std::vector<std::string> fields_missing_in(const std::string& manual, const nlohmann::json& schema) {
  const auto explains = [&](const std::string& word) { return manual.find(word) != std::string::npos; };
  std::vector<std::string> missing;
  for (const std::string& field : fields_of(schema))
    if (!explains('`' + field + '`') && !explains('"' + field + "\": ")) missing.push_back(field);
  return missing;
}

TEST(Manual, ExplainsEveryFieldOfTheSchema) {
  const auto schema = nlohmann::json::parse(text_of("resources/schema/project.schema.json"));
  ASSERT_GT(fields_of(schema).size(), 40u);
  EXPECT_THAT(fields_missing_in(text_of("docs/manual.md"), schema), IsEmpty());
}

TEST(Manual, AFieldItDoesNotExplainIsFound) {
  const auto schema = nlohmann::json::parse(
      R"({"properties": {"dip": {}, "swell": {}, "cuts": {"items": {"properties": {"persistence": {}}}}}})");
  EXPECT_THAT(fields_missing_in("| `dip` | and `cuts` |", schema), ElementsAre("persistence", "swell"));
}

}  // namespace
