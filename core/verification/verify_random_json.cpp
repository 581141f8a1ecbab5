#include "verification/verify_random_json.hpp"

#include <nlohmann/json.hpp>

#include "verification/verify_hard_cases_json.hpp"
#include "verification/verify_random.hpp"

namespace talus {

std::string random_json_text(const std::vector<Trial>& trials, bool complete) {
  using OrderedJson = nlohmann::ordered_json;
  OrderedJson families = OrderedJson::array();
  for (const FamilyResult& result : family_results(trials)) {
    OrderedJson faults = OrderedJson::object();
    for (const auto& [kind, count] : result.faults) faults[std::string(to_string(kind))] = count;
    families.push_back({{"family", result.family},
                        {"scenes", result.scenes},
                        {"held", result.held},
                        {"seconds", result.seconds},
                        {"faults", faults}});
  }
  const OrderedJson scenes = OrderedJson::parse(json_text(trials, complete));
  return OrderedJson{{"passed", scenes["passed"]}, {"families", families}, {"scenes", scenes["scenes"]}}.dump(2) + '\n';
}

std::string family_list_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const RandomFamily& family : random_families())
    list.push_back({{"family", family.name}, {"title", family.title}});
  return nlohmann::ordered_json{{"families", list}}.dump(2) + '\n';
}

}  // namespace talus
