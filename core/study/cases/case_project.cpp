#include "study/cases/case_project.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "study/cases/case_plan.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

/// Of a project that has been read: comments are allowed.
Json json_of(const std::string& text) { return Json::parse(text, nullptr, true, true); }

/// The steps of a pointer, without its escapes. Throws InputError for a text that is none.
std::vector<std::string> steps_of(const std::string& text) {
  std::vector<std::string> steps;
  try {
    for (Pointer pointer(text); !pointer.empty(); pointer.pop_back()) steps.push_back(pointer.back());
  } catch (const nlohmann::json::exception&) {
    throw InputError("", "is no place in a project", "head the column by a place like /joints/J1/friction_angle");
  }
  std::ranges::reverse(steps);
  return steps;
}

/// Which element of a list is meant by its number or by its name; none: there is no such one.
std::optional<std::size_t> element_of(const Json& list, const std::string& step) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (step == std::to_string(i) || (list[i].is_object() && list[i].value("name", Json()) == step)) return i;
  return std::nullopt;
}

/// What there is instead: "it has J1, J2".
std::string members_of(const Json& value) {
  std::string text;
  constexpr std::size_t most = 6;
  std::size_t count = 0;
  if (value.is_array() && !value.empty()) return "it has 0 to " + std::to_string(value.size() - 1);
  if (value.is_object())
    for (const auto& [key, member] : value.items())
      if (++count <= most) text += (text.empty() ? "it has " : ", ") + key;
  return text.empty() ? "look at how the project is written" : text + (count > most ? " …" : "");
}

}  // namespace

std::string numbered_pointer(const std::string& project_text, const std::string& column) {
  const Json project = json_of(project_text);
  const std::vector<std::string> steps = steps_of(column);
  Pointer pointer;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Json& here = project.at(pointer);
    const auto element = here.is_array() ? element_of(here, steps[i]) : std::nullopt;
    const bool last = i + 1 == steps.size();
    if (!(here.is_object() && (last || here.contains(steps[i]))) && !element)
      throw InputError(
          "",
          "the project has no '" + steps[i] + "'" + (pointer.empty() ? std::string() : " in " + pointer.to_string()),
          members_of(here));
    if (element)
      pointer.push_back(std::to_string(*element));
    else
      pointer.push_back(steps[i]);
  }
  return pointer.to_string();
}

std::string with_values(const std::string& project_text, const std::vector<std::string>& pointers,
                        const std::vector<std::string>& values) {
  try {
    Json project = json_of(project_text);
    for (std::size_t i = 0; i < pointers.size(); ++i)
      if (!values[i].empty()) project[Pointer(pointers[i])] = Json::parse(values[i]);
    return change_project_text(project_text, project.dump());
  } catch (const nlohmann::json::exception&) {  // both were right when the study began
    throw InputError("study.json", "is damaged: a project, or a value for one, is none",
                     "begin the study anew with --restart");
  }
}

CaseProject project_of_case(const CasePlan& plan, int number) {
  const std::string text =
      with_values(plan.source_of(number).text, plan.pointers, plan.cases[static_cast<std::size_t>(number)].values);
  return {text, parse_project_in(plan.folder_of(number), text, {plan.allow_outside})};
}

}  // namespace talus
