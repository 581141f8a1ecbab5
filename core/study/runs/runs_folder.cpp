#include "study/runs/runs_folder.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "io/whole_file.hpp"

namespace talus {

namespace {

constexpr const char* plan_name = "study.json";

}  // namespace

RunsFolder::RunsFolder(const std::filesystem::path& folder, std::vector<double> costs)
    : path_(std::filesystem::absolute(folder).lexically_normal()), costs_(std::move(costs)) {}

std::filesystem::path RunsFolder::plan_file() const { return path_ / plan_name; }

std::filesystem::path RunsFolder::run_file(int number) const {
  char name[24];
  std::snprintf(name, sizeof name, "%03d.json", number);
  return path_ / "runs" / name;
}

std::filesystem::path RunsFolder::log_file(int number) const { return run_file(number).replace_extension(".log"); }

std::filesystem::path RunsFolder::results_folder(int number) const {
  return run_file(number).replace_extension(".results");
}

std::vector<int> RunsFolder::missing_runs() const {
  std::vector<int> missing;
  for (int number = 0; number < count(); ++number)
    if (!std::filesystem::exists(run_file(number))) missing.push_back(number);
  return missing;
}

std::optional<std::string> RunsFolder::run_text(int number) const {
  const auto file = run_file(number);
  return std::filesystem::exists(file) ? std::optional(read_whole_file(file)) : std::nullopt;
}

std::string RunsFolder::read(const std::string& name) const { return read_whole_file(path_ / name); }

void RunsFolder::write_run(int number, const std::string& text) const { replace_whole_file(run_file(number), text); }

void RunsFolder::write(const std::string& name, const std::string& text) const {
  replace_whole_file(path_ / name, text);
}

bool RunsFolder::goes_on(bool restart) const {
  const bool begun = std::filesystem::exists(plan_file());
  if (std::filesystem::exists(path_) && !begun &&
      (!std::filesystem::is_directory(path_) || !std::filesystem::is_empty(path_)))
    throw InputError(path_.string(), "is there already and holds no study", "choose another folder with --out");
  if (restart) std::filesystem::remove_all(path_ / "runs");
  return begun && !restart;
}

void RunsFolder::refuse_other(const std::string& other) const {
  if (!other.empty())
    throw InputError(path_.string(), "holds a study of " + other,
                     "choose another folder with --out, or begin anew with --restart");
}

void RunsFolder::write_plan(const std::string& text) const {
  std::error_code failure;
  std::filesystem::create_directories(path_ / "runs", failure);
  if (failure) throw InputError(path_.string(), "cannot be made: " + failure.message(), "choose another folder");
  write(plan_name, text);
}

std::string plan_text(const std::filesystem::path& folder) {
  const auto file = folder / plan_name;
  if (!std::filesystem::exists(file))
    throw InputError(folder.string(), "holds no study", "begin one with talus-cli study");
  return read_whole_file(file);
}

std::string kind_of_study(const std::filesystem::path& folder) {
  try {
    return nlohmann::json::parse(plan_text(folder)).at("kind");
  } catch (const nlohmann::json::exception&) {
    refuse_plan(folder);
  }
}

void refuse_plan(const std::filesystem::path& folder) {
  throw InputError((folder / plan_name).string(), "is no plan of a study that this version understands",
                   "begin anew with --restart");
}

}  // namespace talus
