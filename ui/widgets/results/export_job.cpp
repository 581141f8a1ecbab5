#include "widgets/results/export_job.hpp"

#include "render/film/side_by_side.hpp"
#include "render/views/view_of_results.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

/// A picture, or a film; of several results beside each other.
void draw(const ExportTask& task, Progress& progress) {
  SceneSettings settings = task.settings;
  settings.fine = settings.smooth_outlines = true;
  settings.text_height = 0;  // as the picture's size asks for, not the window's
  Scene scene(*task.system, settings);
  scene.set_stage_names(task.stageNames);
  scene.set_hidden(task.hidden);
  scene.set_troubles(task.troubles);
  scene.set_trails(task.trails);
  scene.set_ghost(task.ghost);
  if (task.settings.trails == Trails::selected) scene.set_selected(task.selected);
  scene.set_actions(task.actions);
  scene.set_joints(task.joints, task.chosenCuts);
  scene.set_pose(task.pose);
  std::vector<Filmed> films{{scene, *task.system, task.times, task.frame}};
  std::vector<std::unique_ptr<Scene>> others;
  for (const ComparedFilm& other : task.compared) {
    others.push_back(std::make_unique<Scene>(*other.system, settings_beside(settings, other.name)));
    others.back()->set_stage_names(other.stageNames);
    others.back()->set_pose(task.pose);
    films.push_back({*others.back(), *other.system, other.times, other.frame, other.name});
  }
  if (task.path.extension() != ".png") {
    render_film(films, task.film, task.path, progress);
    return;
  }
  std::vector<Scene*> scenes;
  for (const Filmed& one : films) {
    scenes.push_back(&one.scene);
    if (!one.times.empty()) one.scene.set_frame(one.frame(0));
  }
  write_png(SideBySideView(scenes, task.film.width, task.film.height, Sampling::best).draw(), task.path);
}

}  // namespace

class ExportJob::JobProgress final : public Progress {
 public:
  explicit JobProgress(ExportJob& job) : job_(job) {}
  void report(double fraction, std::string_view) override {
    QMetaObject::invokeMethod(
        &job_, [job = &job_, fraction] { emit job->progressed(fraction); }, Qt::QueuedConnection);
  }
  bool cancelled() const override { return job_.cancelled_; }

 private:
  ExportJob& job_;
};

ExportJob::~ExportJob() {
  if (!thread_) return;
  thread_->disconnect(this);
  cancelled_ = true;
  thread_->wait();
}

void ExportJob::start(ExportTask task) {
  const QString what = task.what;
  const std::filesystem::path path = task.path;
  start(what, path, [task = std::move(task)](Progress& progress) { draw(task, progress); });
}

void ExportJob::start(const QString& what, const std::filesystem::path& path, Writing write) {
  waiting_.push_back({what, path, std::move(write)});
  if (isBusy()) {
    emit waitingChanged(static_cast<int>(waiting_.size()));
    return;
  }
  startNext();
  emit busyChanged(true);
}

void ExportJob::startNext() {
  cancelled_ = false;
  Waiting task = std::move(waiting_.front());
  waiting_.pop_front();
  const QString what = task.what;
  thread_.reset(QThread::create([this, task = std::move(task)] { work(task); }));
  connect(thread_.get(), &QThread::finished, this, [this] {
    thread_->wait();
    thread_.reset();
    std::exchange(outcome_, {})();
    if (waiting_.empty())
      emit busyChanged(false);
    else
      startNext();
  });
  thread_->start(QThread::LowPriority);
  emit started(what);
  emit waitingChanged(static_cast<int>(waiting_.size()));
}

void ExportJob::work(const Waiting& task) {
  const std::string file = task.path.string();
  try {
    JobProgress progress(*this);
    task.write(progress);
    outcome_ = [this, file] { emit finished(text(file)); };
  } catch (const Cancelled&) {
    outcome_ = [this] { emit cancelledByUser(); };
  } catch (const InputError& error) {
    outcome_ = [this, error] { emit failed(error); };
  } catch (const std::exception& error) {
    outcome_ = [this, failure = InputError(file, error.what(), "choose another place or size")] {
      emit failed(failure);
    };
  }
}

}  // namespace talus
