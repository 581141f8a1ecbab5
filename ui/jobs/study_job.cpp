#include "jobs/study_job.hpp"

#include <cstdlib>
#include <string>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/installed.hpp"
#include "study/accuracy/study_record.hpp"
#include "study/runs/local_engine.hpp"

namespace talus {

namespace {

/// With the settings of the study that is there, if it is of the same project: they may have been chosen.
StudyPlan plan_for(const StudyRequest& request) {
  StudyPlan plan = make_plan(request);
  try {
    const StudyFolder there(study_folder_of(plan.project_file));
    if (there.plan().fingerprint == plan.fingerprint) plan.ladder = there.plan().ladder;
  } catch (const InputError&) {
    // none, or none that can be read: folder_for takes its place or says why not
  }
  return plan;
}

StudyFolder folder_for(const StudyPlan& plan) {
  const std::filesystem::path place = study_folder_of(plan.project_file);
  try {
    return {place, plan, false};
  } catch (const InputError&) {
    return {place, plan, true};  // refuses, too, a folder that holds no study
  }
}

/// By talus-cli, as a user would: the chart is drawn by a process of its own, where the window's own pictures are not.
void draw_up(const StudyFolder& folder) {
  const std::vector<std::string> command{"study", "accuracy", folder.plan().project_file.string(), "--collect"};
  const int exit_code = output_of(command_line_program().string(), command).exit_code;
  constexpr int not_all_completed = 1;  // that the study tells, a row a run
  if (exit_code == 0 || exit_code == not_all_completed) return;
  throw InputError(folder.path().string(), "cannot be drawn up",
                   "talus-cli study accuracy " + folder.plan().project_file.string() + " --collect says why");
}

void make_study(const StudyRequest& request, Progress& progress) {
  const StudyFolder folder = folder_for(plan_for(request));
  run_locally(folder, {command_line_program(), free_cores()}, progress);
  draw_up(folder);
}

}  // namespace

StudyJob::StudyJob(QObject* parent) : QObject(parent) {
  connect(&work_, &BackgroundJob::progressed, this, &StudyJob::progressed);
  connect(&work_, &BackgroundJob::ended, this, [this] { emit ended(problem_); });
}

void StudyJob::begin(const StudyRequest& request) {
  problem_.clear();
  const auto make = [request](Progress& progress, const auto& ended) {
    try {
      make_study(request, progress);
    } catch (const std::exception& error) {
      ended(std::string(error.what()));
    }
  };
  work_.start<std::string>(make, [this](const std::string& problem) { problem_ = QString::fromStdString(problem); });
}

std::filesystem::path command_line_program() {
  if (const char* named = std::getenv("TALUS_CLI")) return named;
  return program_folder() / "talus-cli";
}

}  // namespace talus
