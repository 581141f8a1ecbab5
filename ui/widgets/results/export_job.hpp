#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <deque>
#include <functional>
#include <memory>

#include "base/error.hpp"
#include "render/film/movie.hpp"
#include "render/scene/scene.hpp"
#include "widgets/results/data_export.hpp"

namespace talus {

/// Results that are drawn beside those of the view, or filmed over them.
struct ComparedFilm {
  std::shared_ptr<const BlockSystem> system;
  std::vector<double> times;                               ///< s, of the frames
  std::function<std::shared_ptr<const Frame>(int)> frame;  ///< by number, called on the exporting thread
  std::string name;
  std::vector<std::string> stageNames{};
};

/// What a picture or film shows: the window's view, by value.
struct ExportTask {
  QString what;  ///< "Film"
  std::shared_ptr<const BlockSystem> system;
  SceneSettings settings;
  CameraPose pose;
  std::vector<int> hidden;
  std::vector<int> selected{};  ///< whose trails are drawn, where those of all are not
  std::vector<ConvergenceTrouble> troubles;
  std::shared_ptr<const BlockTrails> trails{};
  Ghost ghost{};  ///< of a picture
  std::vector<ActionGlyph> actions;
  std::shared_ptr<const std::vector<JointFace>> joints{};  ///< null: none are drawn
  std::vector<int> chosenCuts{};                           ///< whose joints are drawn stronger
  std::vector<std::string> stageNames;
  /// Frames by number, called on the exporting thread.
  std::function<std::shared_ptr<const Frame>(int)> frame;
  std::vector<double> times;   ///< s, of the frames: one for a picture, or none for the rock as set up
  std::filesystem::path path;  ///< .png, .mp4, .gif
  FilmOptions film;            ///< width and height of a picture too
  std::vector<ComparedFilm> compared{};
};

/// Writes pictures, films, data and reports on a thread of its own; what is drawn has a GL context of its own.
class ExportJob : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  /// Cancels and waits.
  ~ExportJob() override;

  bool isBusy() const { return thread_ != nullptr; }
  /// One at a time: what is asked for meanwhile waits for its turn.
  void start(ExportTask task);
  /// `what`: "Report"; `path`: the file or folder that `write` makes.
  void start(const QString& what, const std::filesystem::path& path, Writing write);
  /// The one that is being written; those that wait go on.
  void cancel() { cancelled_ = true; }

 signals:
  void started(const QString& what);
  void waitingChanged(int count);
  void busyChanged(bool busy);
  void progressed(double fraction);
  void finished(const QString& path);
  void cancelledByUser();
  void failed(const talus::InputError& error);

 private:
  class JobProgress;
  struct Waiting {
    QString what;
    std::filesystem::path path;
    Writing write;
  };
  void startNext();
  void work(const Waiting& task);

  std::deque<Waiting> waiting_;
  std::unique_ptr<QThread> thread_;
  std::atomic<bool> cancelled_ = false;
  std::function<void()> outcome_;  ///< set by the worker, called when its thread has ended
};

}  // namespace talus
