#include "session/block_survey.hpp"

#include <algorithm>
#include <tuple>

#include "base/error.hpp"
#include "jobs/background_job.hpp"
#include "session/current_project.hpp"

namespace talus {

namespace {

/// All that decides whether and how blocks leave their place, apart from their shapes.
auto strengths(const Project& project) {
  return std::tie(project.joints, project.default_joint, project.interfaces, project.materials, project.gravity);
}

template <class Named>
bool haveTheSameNames(const std::vector<Named>& a, const std::vector<Named>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Named& x, const Named& y) { return x.name == y.name; });
}

struct Survey {
  std::shared_ptr<const BlockSurvey::Facts> facts;
  std::shared_ptr<const MeshSurvey> mesh;
};

}  // namespace

BlockSurvey::BlockSurvey(CurrentProject& project) : project_(project), job_(std::make_unique<BackgroundJob>()) {
  connect(&project_, &CurrentProject::systemChanged, this, &BlockSurvey::takeSystem);
  connect(&project_.document(), &Document::projectChanged, this, &BlockSurvey::takeProject);
  connect(job_.get(), &BackgroundJob::ended, this, [this] {
    if (isLate_) start();
  });
}

BlockSurvey::~BlockSurvey() = default;

bool BlockSurvey::isBusy() const { return job_->isBusy(); }

void BlockSurvey::want() {
  wanted_ = true;
  if (project_.system() && !facts_ && !isBusy()) start();
}

void BlockSurvey::takeSystem() {
  facts_.reset();
  mesh_.reset();
  emit changed();
  if (wanted_ || isBusy()) start();
}

void BlockSurvey::takeProject() {
  if (!project_.system() || (!facts_ && !isBusy())) return;
  if (strengths(projectOfBlocks()) != strengths(surveyed_)) start();
}

/// Blocks count joints and materials as the project did that they were built from.
Project BlockSurvey::projectOfBlocks() const {
  const Project& now = project_.document().project();
  Project built = project_.builtFrom();
  if (!haveTheSameNames(built.joints, now.joints) || !haveTheSameNames(built.materials, now.materials)) return built;
  built.joints = now.joints;
  built.default_joint = now.default_joint;
  built.interfaces = now.interfaces;
  built.materials = now.materials;
  built.gravity = now.gravity;
  return built;
}

/// A survey that goes on ends first: waiting for it would hold the window up.
void BlockSurvey::start() {
  isLate_ = isBusy();
  if (isLate_) return job_->cancel();
  if (!project_.system()) return;
  surveyed_ = projectOfBlocks();
  const auto work = [project = surveyed_, system = project_.system(), mesh = mesh_](Progress& progress,
                                                                                    const auto& tell) {
    Survey survey{std::make_shared<const Facts>(block_facts(project, *system)), mesh};
    if (!mesh) survey.mesh = std::make_shared<const MeshSurvey>(survey_mesh(*system, progress));
    tell(survey);
  };
  job_->start<Survey>(work, [this](const Survey& survey) {
    if (isLate_) return;
    facts_ = survey.facts;
    mesh_ = survey.mesh;
    emit changed();
  });
}

}  // namespace talus
