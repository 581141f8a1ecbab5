#include "study/cases/case_findings.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace talus {

std::optional<double> CaseFindings::number(const std::string& name) const {
  const auto found = std::ranges::find(numbers, name, &CaseNumber::name);
  return found == numbers.end() ? std::nullopt : std::optional(found->value);
}

std::string case_findings_text(const CaseFindings& findings) {
  nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
  for (const CaseNumber& one : findings.numbers) numbers.push_back({one.name, one.value});
  const nlohmann::ordered_json json = {{"status", findings.status}, {"reason", findings.reason}, {"numbers", numbers}};
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

CaseFindings case_findings_from(const std::string& text, const std::filesystem::path& file) {
  try {
    const auto json = nlohmann::json::parse(text);
    CaseFindings findings{json.at("status"), json.at("reason"), {}};
    for (const auto& one : json.at("numbers"))
      if (!one.at(1).is_null()) findings.numbers.push_back({one.at(0), one.at(1)});  // what is not finite is null
    return findings;
  } catch (const nlohmann::json::exception&) {
    throw InputError(file.string(), "is no case of a study that this version understands",
                     "delete it, and go on: it is run again");
  }
}

}  // namespace talus
