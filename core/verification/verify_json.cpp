#include "verification/verify_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Finding& finding) {
  return {{"quantity", finding.quantity}, {"unit", finding.unit},      {"expected", finding.expected},
          {"computed", finding.computed}, {"error", finding.error()},  {"tolerance", finding.tolerance},
          {"absolute", finding.absolute}, {"held", !finding.reported}, {"passed", finding.passed()}};
}

Json json_of(const CaseTable& table) {
  return {{"title", table.title}, {"columns", table.columns}, {"rows", table.rows}};
}

Json json_of(const Repetition& repetition) {
  return {{"scale", repetition.options.scale},
          {"threads", repetition.options.threads},
          {"same_bits", repetition.same_bits},
          {"largest_difference", repetition.largest.value},
          {"quantity", repetition.largest.quantity},
          {"about_zero", repetition.about_zero.value},
          {"quantity_about_zero", repetition.about_zero.quantity},
          {"reason", repetition.failure},
          {"passed", repetition.passed}};
}

Json json_of(const CaseResult& result);

template <class Items>
Json list_of(const Items& items) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(json_of(item));
  return list;
}

Json json_of(const CaseResult& result) {
  return {{"case", result.name},
          {"title", result.title},
          {"source", result.source},
          {"status", result.failure.empty() ? "completed" : "failed"},
          {"reason", result.failure},
          {"seconds", result.seconds},
          {"passed", result.passed()},
          {"scale", result.options.scale},
          {"threads", result.options.threads},
          {"checks", list_of(result.outcome.findings)},
          {"tables", list_of(result.outcome.tables)},
          {"remarks", result.outcome.remarks},
          {"repetitions", list_of(result.repetitions)}};
}

}  // namespace

std::string json_text(const std::vector<CaseResult>& results, bool complete) {
  const bool passed =
      complete && std::all_of(results.begin(), results.end(), [](const CaseResult& r) { return r.passed(); });
  return Json{{"passed", passed}, {"cases", list_of(results)}}.dump(2, ' ', false, Json::error_handler_t::replace) +
         '\n';
}

std::string list_json(const std::vector<KnownCase>& cases) {
  Json list = Json::array();
  for (const KnownCase& known : cases)
    list.push_back(
        {{"case", known.name}, {"title", known.title}, {"source", known.source}, {"takes_long", known.takes_long}});
  return Json{{"cases", list}}.dump(2) + '\n';
}

}  // namespace talus
