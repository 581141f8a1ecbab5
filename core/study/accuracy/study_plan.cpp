#include "study/accuracy/study_plan.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <variant>

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "io/whole_file.hpp"
#include "model/solid_shape.hpp"
#include "study/accuracy/setting_json.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* plan_name = "study.json";

/// FNV-1a, 64 bits.
std::uint64_t hash(std::uint64_t state, const std::string& bytes) {
  for (const char c : bytes) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return state;
}

std::string fingerprint_of(const std::string& text, const Project& project, const std::filesystem::path& folder) {
  std::uint64_t state = hash(0xcbf29ce484222325, text);
  for (const Solid& solid : project.solids)
    if (const std::string* file = file_of(solid.shape)) state = hash(state, read_whole_file(folder / *file));
  char digits[20];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(state));
  return digits;
}

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
  const auto file = folder / plan_name;
  if (!std::filesystem::exists(file))
    throw InputError(folder.string(), "holds no study", "begin one with talus-cli study accuracy");
  try {
    return plan_of(Json::parse(read_whole_file(file)));
  } catch (const nlohmann::json::exception&) {
    throw InputError(file.string(), "is no plan of a study that this version understands", "begin anew with --restart");
  }
}

/// A folder that a study may take: new, empty, or a study's. Only such a one is emptied by a restart.
void check_free(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder) || std::filesystem::exists(folder / plan_name)) return;
  if (!std::filesystem::is_directory(folder) || !std::filesystem::is_empty(folder))
    throw InputError(folder.string(), "is there already and holds no study", "choose another folder with --out");
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

StudyFolder::StudyFolder(std::filesystem::path folder, const StudyPlan& plan, bool restart)
    : path_(std::filesystem::absolute(std::move(folder)).lexically_normal()), plan_(plan) {
  check_free(path_);
  if (restart) std::filesystem::remove_all(path_ / "runs");
  if (!restart && std::filesystem::exists(path_ / plan_name)) {
    const StudyPlan old = read_plan(path_);
    if (const std::string other = difference(old, plan); !other.empty())
      throw InputError(path_.string(), "holds a study of " + other,
                       "choose another folder with --out, or begin anew with --restart");
    if (old.measure == plan.measure && old.repeats == plan.repeats) return;
  }
  std::error_code failure;
  std::filesystem::create_directories(path_ / "runs", failure);
  if (failure) throw InputError(path_.string(), "cannot be made: " + failure.message(), "choose another folder");
  replace_whole_file(path_ / plan_name, json_of(plan).dump(2) + "\n");
}

StudyFolder::StudyFolder(std::filesystem::path folder)
    : path_(std::filesystem::absolute(std::move(folder)).lexically_normal()), plan_(read_plan(path_)) {}

std::filesystem::path StudyFolder::run_file(int number) const {
  char name[24];
  std::snprintf(name, sizeof name, "%03d.json", number);
  return path_ / "runs" / name;
}

std::filesystem::path StudyFolder::log_file(int number) const { return run_file(number).replace_extension(".log"); }

std::vector<int> StudyFolder::missing_runs() const {
  std::vector<int> missing;
  for (int number = 0; number < plan_.runs(); ++number)
    if (!std::filesystem::exists(run_file(number))) missing.push_back(number);
  return missing;
}

}  // namespace talus
