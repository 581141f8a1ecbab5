#include "widgets/export_job.hpp"

#include "base/error.hpp"
#include "render/offscreen.hpp"

namespace talus {

class ExportJob::FilmProgress final : public Progress {
 public:
  explicit FilmProgress(ExportJob& job) : job_(job) {}
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
  Q_ASSERT(!isBusy());
  cancelled_ = false;
  thread_.reset(QThread::create([this, task = std::move(task)] { work(task); }));
  connect(thread_.get(), &QThread::finished, this, [this] {
    thread_->wait();
    thread_.reset();
    emit busyChanged(false);
    std::exchange(outcome_, {})();
  });
  thread_->start(QThread::LowPriority);
  emit busyChanged(true);
}

void ExportJob::work(const ExportTask& task) {
  QString place = QString::fromStdString(task.path.string()), problem, remedy = tr("choose another place or size");
  try {
    draw(task);
    outcome_ = [this, place] { emit finished(place); };
    return;
  } catch (const Cancelled&) {
    outcome_ = [this] { emit cancelledByUser(); };
    return;
  } catch (const InputError& error) {
    place = QString::fromStdString(error.place());
    problem = QString::fromStdString(error.problem());
    remedy = QString::fromStdString(error.remedy());
  } catch (const std::exception& error) {
    problem = QString::fromUtf8(error.what());
  }
  outcome_ = [=, this] { emit failed(place, problem, remedy); };
}

void ExportJob::draw(const ExportTask& task) {
  SceneSettings settings = task.settings;
  settings.fine = true;
  settings.text_height = 0;  // as the picture's size asks for, not the window's
  Scene scene(*task.system, settings);
  scene.set_stage_names(task.stageNames);
  scene.set_hidden(task.hidden);
  scene.set_struggles(task.struggles);
  scene.set_pose(task.pose);
  if (task.path.extension() == ".png") {
    if (task.frameCount > 0) scene.set_frame(task.frame(task.firstFrame));
    render_png(scene, task.path, task.film.width, task.film.height);
    return;
  }
  FilmProgress progress(*this);
  render_film(
      scene, task.frameCount, [&](int number) { return task.frame(task.firstFrame + number); }, task.path, task.film,
      progress);
}

}  // namespace talus
