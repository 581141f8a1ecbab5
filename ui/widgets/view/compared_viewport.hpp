#pragma once

#include <QFrame>
#include <QWidget>
#include <memory>
#include <vector>

#include "jobs/latest_job.hpp"
#include "render/scene/scene.hpp"
#include "session/compared_results.hpp"
#include "widgets/view/camera_moves.hpp"

class QToolButton;

namespace talus {

class RenderSurface;
class Viewport;

/// Beside the view: results that are compared, at the same moment, from the same place and in the same colours. Either
/// camera is moved by the other's: left drag turns, middle drag pans, the wheel zooms. Its blocks can be drawn over
/// those of the view, as outlines.
class ComparedViewport : public QFrame {
  Q_OBJECT
 public:
  ComparedViewport(ComparedResults& all, std::shared_ptr<ComparedRun> run, Viewport& viewport);
  ~ComparedViewport() override;

  const ComparedRun& run() const { return *run_; }
  /// Is seen no more, and goes when nothing of it is at work.
  void end();
  /// Null until the blocks can be drawn.
  const Scene* scene() const { return scene_.get(); }
  RenderSurface& surface() { return *surface_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make();
  void follow();
  void drawOver();

  ComparedResults& all_;
  std::shared_ptr<ComparedRun> run_;
  Viewport& viewport_;
  RenderSurface* surface_;
  QToolButton *end_, *over_;
  bool isOver_ = false;  ///< its edges are those over the view
  std::shared_ptr<Scene> scene_;
  CameraMouse mouse_{0.35};  // as in the view beside it
  LatestJob drawing_;        ///< last: its thread ends before the others go
};

/// The first view and one beside it for each run that is compared, as panel_places places them.
class ComparedViewports : public QWidget {
  Q_OBJECT
 public:
  ComparedViewports(ComparedResults& all, Viewport& viewport);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void follow();
  void arrange();

  ComparedResults& all_;
  Viewport& viewport_;
  std::vector<ComparedViewport*> views_;
};

}  // namespace talus
