#include "study/accuracy/study_plan.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "io/whole_file.hpp"
#include "study/accuracy/setting_json.hpp"
#include "study/runs/fingerprint.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const StudyPlan& plan) {
  Json settings = Json::array(), left_out = Json::array();
  for (const Setting& setting : plan.ladder.settings) settings.push_back(setting_json(setting));
  for (const LeftOut& one : plan.ladder.left_out) left_out.push_back({{"what", one.what}, {"reason", one.reason}});
  return {{"talus_study", 1},
          {"kind", "accuracy"},
          {"program", plan.program},
          {"project_file", plan.project_file.string()},
          {"allow_outside", plan.allow_outside},
          {"fingerprint", plan.fingerprint},
          {"settings", settings},
          {"finest", plan.ladder.finest},
          {"repeats", plan.repeats},
          {"measure", plan.measure ? Json(to_string(*plan.measure)) : Json()},
          {"left_out", left_out},
          {"project_text", plan.project_text}};
}

StudyPlan plan_of(const Json& json) {
  StudyPlan plan;
  plan.program = json.at("program");
  plan.project_file = json.at("project_file").get<std::string>();
  plan.allow_outside = json.at("allow_outside");
  plan.fingerprint = json.at("fingerprint");
  plan.project_text = json.at("project_text");
  for (const Json& setting : json.at("settings")) plan.ladder.settings.push_back(setting_of(setting));
  plan.ladder.finest = json.at("finest");
  plan.repeats = json.value("repeats", 1);  // studies made before there were more
  if (const Json measure = json.value("measure", Json()); !measure.is_null())
    plan.measure = study_measure_from(measure);
  for (const Json& one : json.at("left_out")) plan.ladder.left_out.push_back({one.at("what"), one.at("reason")});
  return plan;
}

/// What makes a plan another one; empty where it is the same.
std::string difference(const StudyPlan& old, const StudyPlan& now) {
  if (old.fingerprint != now.fingerprint) return "another project, or this one before it was changed";
  if (old.program != now.program) return "the version " + old.program + " of the program";
  if (old.ladder.settings != now.ladder.settings || old.ladder.finest != now.ladder.finest) return "other settings";
  if (old.repeats > now.repeats) return std::to_string(old.repeats) + " runs a setting";
  return {};
}

StudyPlan read_plan(const std::filesystem::path& folder) {
  try {
    return plan_of(Json::parse(plan_text(folder)));
  } catch (const nlohmann::json::exception&) {
    refuse_plan(folder);
  }
}

std::vector<double> costs_of(const StudyPlan& plan) {
  std::vector<double> costs;
  for (int run = 0; run < plan.runs(); ++run) costs.push_back(relative_cost(plan.setting_of(run)));
  return costs;
}

/// Throws InputError where no run would have what is to be measured.
void check_measure(std::optional<StudyMeasure> measure, const Project& project) {
  const bool has_stress = std::any_of(project.monitors.begin(), project.monitors.end(),
                                      [](const Monitor& monitor) { return monitor.stress; });
  if (measure == StudyMeasure::stress && !has_stress)
    throw InputError("measure 'stress'", "no monitor of the project records stress",
                     "give a monitor \"stress\": true, or measure something else");
}

}  // namespace

StudyPlan make_plan(const StudyRequest& request) {
  StudyPlan plan;
  plan.program = request.program;
  plan.project_file = std::filesystem::absolute(request.project_file).lexically_normal();
  plan.allow_outside = request.allow_outside;
  plan.project_text = read_whole_file(plan.project_file);
  const Project project = read_project(plan.project_file, {plan.allow_outside});
  plan.fingerprint = fingerprint_of(plan.project_text, project, plan.project_file.parent_path());
  plan.ladder = make_ladder(project, request.wish);
  plan.repeats = request.repeats;
  check_measure(request.measure, project);
  plan.measure = request.measure;
  return plan;
}

Project project_of(const StudyPlan& plan) { return parse_project(plan.project_text, {plan.allow_outside}); }

std::string text_of(const Project& project, const StudyPlan& plan) { return write_project(project, plan.project_text); }

StudyFolder::StudyFolder(const std::filesystem::path& folder, StudyPlan plan)
    : RunsFolder(folder, costs_of(plan)), plan_(std::move(plan)) {}

StudyFolder::StudyFolder(const std::filesystem::path& folder, const StudyPlan& plan, bool restart)
    : StudyFolder(folder, plan) {
  if (goes_on(restart)) {
    const StudyPlan old = read_plan(path());
    refuse_other(difference(old, plan));
    if (old.measure == plan.measure && old.repeats == plan.repeats) return;
  }
  write_plan(json_of(plan).dump(2) + "\n");
}

StudyFolder::StudyFolder(const std::filesystem::path& folder) : StudyFolder(folder, read_plan(folder)) {}

}  // namespace talus
