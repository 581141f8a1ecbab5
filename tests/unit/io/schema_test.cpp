#include <fstream>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/project_file.hpp"
#include "unit/io/sample_project.hpp"

namespace talus {
namespace {

using nlohmann::json;

json schema() { return json::parse(std::ifstream(TALUS_SOURCE_DIR "/resources/schema/project.schema.json")); }

void for_each_object(const json& value, const auto& visit) {
  if (value.is_object()) visit(value);
  for (const auto& item : value) {
    if (item.is_structured()) for_each_object(item, visit);
  }
}

/// All keys the schema allows.
std::set<std::string> all_keys() {
  std::set<std::string> keys;
  for_each_object(schema(), [&](const json& rule) {
    if (!rule.contains("properties") || !rule.contains("type")) return;
    for (const auto& [key, property] : rule.at("properties").items()) keys.insert(key);
  });
  return keys;
}

TEST(Schema, AllowsNoKeyThatTheFullProjectDoesNotTest) {
  for (const auto& key : all_keys()) {
    EXPECT_NE(test::full_project.find('"' + key + "\":"), std::string::npos) << key;
  }
}

TEST(Schema, DescribesEveryKeyAndRefusesAllOthers) {
  const json root = schema();
  for_each_object(root, [&](const json& rule) {
    if (!rule.contains("properties") || !rule.contains("type")) return;
    EXPECT_EQ(rule.at("additionalProperties"), json(false)) << rule.dump().substr(0, 200);
    for (const auto& [key, property] : rule.at("properties").items()) {
      const bool by_reference = property.contains("$ref");
      const json& described =
          by_reference ? root.at(json::json_pointer(property.at("$ref").get<std::string>().substr(1))) : property;
      EXPECT_TRUE(described.contains("description")) << key;
    }
  });
}

/// What is written holds every key that the schema allows, so that reader, writer and schema cannot drift apart.
TEST(Schema, TheWriterWritesEveryKey) {
  const std::string written = write_project(parse_project(test::full_project));
  for (const auto& key : all_keys()) {
    EXPECT_NE(written.find('"' + key + "\":"), std::string::npos) << key;
  }
}

}  // namespace
}  // namespace talus
