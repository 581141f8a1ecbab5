#pragma once

#include <QElapsedTimer>
#include <QFrame>
#include <QRectF>
#include <QTimer>
#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;

namespace talus {

class Document;
class CurrentRun;
class Playback;

/// The line itself: bands for stages, marks for events, a handle at the frame in view.
class TimelineTrack : public QWidget {
  Q_OBJECT
 public:
  TimelineTrack(Document& document, CurrentRun& run, Playback& playback);

  struct StageName {
    QRectF place;
    QString words;
  };
  /// Those that have their room: of the stage that goes on, all that is before it. The tooltip tells the others.
  std::vector<StageName> stageNames() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Band {
    double begin, end;
    QString name;
  };
  std::vector<Band> bands() const;
  double end() const;
  double xAt(double time) const;
  void scrubTo(double x);

  Document& document_;
  CurrentRun& run_;
  Playback& playback_;
};

/// Under the view: play, pause, frame steps, speed, and the track to scrub.
class Timeline : public QFrame {
  Q_OBJECT
 public:
  Timeline(Document& document, CurrentRun& run, Playback& playback);
  bool isPlaying() const { return timer_.isActive(); }
  /// Seconds of the model in a second of play: 1 is real time.
  double speed() const;

 signals:
  void speedChanged();

 public slots:
  void togglePlay();
  void stepBy(int frames);
  void goToFirst();
  void goToLast();

 private:
  void tick();
  void refresh();
  void setPlaying(bool plays);

  Playback& playback_;
  QToolButton *play_, *loop_, *back_, *forward_;
  QLabel *time_, *total_;
  QComboBox* speed_;
  TimelineTrack* track_;
  QTimer timer_;
  QElapsedTimer clock_;
  double playedFrom_ = 0;  ///< s of model time at which play began
};

}  // namespace talus
