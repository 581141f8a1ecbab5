#include "io/project_change.hpp"

#include <nlohmann/json.hpp>

#include "io/project_file.hpp"
#include "io/project_to_json.hpp"

namespace talus {

namespace {

using nlohmann::json;

/// With all defaults, so that two ways to say the same are the same.
json parsed(const std::string& text) {
  return project_to_json(parse_project(text, {.allow_outside = true, .unfinished = true}));
}

/// Makes the last stage of `before` as long as it is now, where it has become longer.
void allow_longer(json& before, const json& now) {
  for (const char* length : {"duration", "steps"}) {
    if (!before.contains(length) || !now.contains(length)) continue;
    if (now[length] > before[length]) before[length] = now[length];
  }
}

}  // namespace

std::optional<std::string> change_since_run(const std::string& text_of_run, const std::string& text_now) {
  json before = parsed(text_of_run), now = parsed(text_now);
  if (before.contains("stages") && now.contains("stages") && !before["stages"].empty() &&
      now["stages"].size() >= before["stages"].size()) {
    json &stages = before["stages"], &stages_now = now["stages"];
    allow_longer(stages.back(), stages_now[stages.size() - 1]);
    stages_now.erase(stages_now.begin() + static_cast<json::difference_type>(stages.size()), stages_now.end());
  }
  const json changes = json::diff(before, now);
  if (changes.empty()) return std::nullopt;
  return changes.front().at("path").get<std::string>().substr(1);
}

}  // namespace talus
