#include "study/cases/case_plan.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/error.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const CasePlan& plan) {
  Json projects = Json::array(), cases = Json::array();
  for (const CasePlan::Source& source : plan.projects)
    projects.push_back({{"file", source.file.string()}, {"text", source.text}});
  for (const CasePlan::Case& one : plan.cases)
    cases.push_back(
        {{"name", one.name}, {"project", one.project}, {"values", one.values}, {"fingerprint", one.fingerprint}});
  return {{"talus_study", 1},
          {"kind", "cases"},
          {"program", plan.program},
          {"allow_outside", plan.allow_outside},
          {"keep_results", plan.keep_results},
          {"projects", projects},
          {"columns", plan.columns},
          {"pointers", plan.pointers},
          {"cases", cases}};
}

CasePlan plan_of(const Json& json) {
  CasePlan plan;
  plan.program = json.at("program");
  plan.allow_outside = json.at("allow_outside");
  plan.keep_results = json.at("keep_results");
  for (const Json& one : json.at("projects"))
    plan.projects.push_back({one.at("file").get<std::string>(), one.at("text")});
  plan.columns = json.at("columns");
  plan.pointers = json.at("pointers");
  for (const Json& one : json.at("cases")) {
    plan.cases.push_back({one.at("name"), one.at("project"), one.at("values"), one.at("fingerprint")});
    plan.projects.at(static_cast<std::size_t>(plan.cases.back().project));
    if (plan.cases.back().values.size() != plan.pointers.size()) throw std::out_of_range("values");
  }
  if (plan.columns.size() != plan.pointers.size()) throw std::out_of_range("columns");
  return plan;
}

CasePlan read_plan(const std::filesystem::path& folder) {
  if (kind_of_study(folder) != "cases")
    throw InputError(folder.string(), "holds a study of another kind", "choose another folder with --out");
  try {
    return plan_of(Json::parse(plan_text(folder)));
  } catch (const std::exception&) {  // what JSON or a list says of it
    refuse_plan(folder);
  }
}

/// What makes a plan another one; empty where it is the same, or goes on behind the cases of the old one.
std::string difference(const CasePlan& old, const CasePlan& now) {
  if (old.program != now.program) return "the version " + old.program + " of the program";
  if (old.keep_results != now.keep_results) return old.keep_results ? "results that are kept" : "no kept results";
  if (old.cases.size() > now.cases.size()) return std::to_string(old.cases.size()) + " cases";
  for (std::size_t i = 0; i < old.cases.size(); ++i)
    if (old.cases[i].name != now.cases[i].name || old.cases[i].fingerprint != now.cases[i].fingerprint)
      return "another case '" + old.cases[i].name + "'";
  return {};
}

/// Nothing is known of what a case will take.
std::vector<double> equal_costs(const CasePlan& plan) { return std::vector<double>(plan.cases.size(), 1.0); }

}  // namespace

CaseFolder::CaseFolder(const std::filesystem::path& folder, CasePlan plan)
    : RunsFolder(folder, equal_costs(plan)), plan_(std::move(plan)) {}

CaseFolder::CaseFolder(const std::filesystem::path& folder, const CasePlan& plan, bool restart)
    : CaseFolder(folder, plan) {
  if (goes_on(restart)) {
    const CasePlan old = read_plan(path());
    refuse_other(difference(old, plan));
    if (old.cases.size() == plan.cases.size()) return;
  }
  write_plan(json_of(plan).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");  // file names are any bytes
}

CaseFolder::CaseFolder(const std::filesystem::path& folder) : CaseFolder(folder, read_plan(folder)) {}

}  // namespace talus
