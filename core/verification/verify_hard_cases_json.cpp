#include "verification/verify_hard_cases_json.hpp"

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

/// 16 digits: JSON's numbers do not hold 64 bits.
std::string hexadecimal(std::uint64_t number) {
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << number;
  return text.str();
}

Json json_of(const Trial& trial) {
  Json repetitions = Json::array();
  for (const TrialRepetition& again : trial.repetitions)
    repetitions.push_back(
        {{"threads", again.threads}, {"same_bits", again.difference.empty()}, {"reason", again.difference}});
  const Json elsewhere = trial.elsewhere ? Json{{"same", trial.elsewhere->difference.empty()},
                                                {"apart", trial.elsewhere->apart},
                                                {"reason", trial.elsewhere->difference}}
                                         : Json(nullptr);
  return {{"scene", trial.name},
          {"group", trial.group},
          {"title", trial.title},
          {"source", trial.source},
          {"expected", trial.expected},
          {"status", to_string(trial.ending)},
          {"reason", trial.reason},
          {"seconds", trial.seconds},
          {"passed", trial.passed()},
          {"threads", trial.threads},
          {"steps", trial.steps},
          {"iterations_per_step", trial.iterations_per_step()},
          {"most_iterations", trial.most_iterations},
          {"cuts", trial.cuts},
          {"penetration", trial.penetration},
          {"energy_growth", trial.energy_growth},
          {"remainder", trial.remainder},
          {"least_volume", trial.least_volume},
          {"interpenetration", trial.interpenetration},
          {"fingerprint", hexadecimal(fingerprint(trial))},
          {"faults", faults(trial)},
          {"known_shortfall", trial.known_shortfall},
          {"repetitions", repetitions},
          {"elsewhere", elsewhere}};
}

}  // namespace

std::string json_text(const std::vector<Trial>& trials, bool complete) {
  Json list = Json::array();
  for (const Trial& trial : trials) list.push_back(json_of(trial));
  const bool passed =
      complete && std::all_of(trials.begin(), trials.end(), [](const Trial& trial) { return trial.passed(); });
  return Json{{"passed", passed}, {"scenes", list}}.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string list_json(const std::vector<HardCase>& scenes) {
  Json list = Json::array();
  for (const HardCase& scene : scenes)
    list.push_back({{"scene", scene.name},
                    {"group", scene.group},
                    {"title", scene.title},
                    {"source", scene.source},
                    {"takes_long", scene.takes_long}});
  return Json{{"scenes", list}}.dump(2) + '\n';
}

}  // namespace talus
