#pragma once

#include <QFrame>
#include <memory>
#include <vector>

#include "jobs/latest_job.hpp"
#include "render/paint/panel_grid.hpp"
#include "render/scene/scene.hpp"
#include "session/compared_results.hpp"
#include "widgets/view/camera_moves.hpp"

class QGridLayout;
class QToolButton;

namespace talus {

class RenderSurface;
class Viewport;

/// What results are shown by that are compared under a name, beside a view that is shown by `view`.
SceneSettings settingsBeside(const SceneSettings& view, const std::string& name);

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
  std::shared_ptr<Scene> scene_;
  CameraMouse mouse_{0.35};  // as in the view beside it
  LatestJob drawing_;        ///< last: its thread ends before the others go
};

/// Keeps a view beside the first one for each run that is compared, in rows as they are largest.
class ComparedViewports : public QObject {
  Q_OBJECT
 public:
  /// `grid`: all that its parent widget has; the first view is put there, too.
  ComparedViewports(ComparedResults& all, Viewport& viewport, QGridLayout& grid);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  /// Where another grid than now is the best one, or other views are in it.
  void arrange();

  ComparedResults& all_;
  Viewport& viewport_;
  QGridLayout& grid_;
  std::vector<ComparedViewport*> views_;
  std::vector<QWidget*> shown_;  ///< as they stand in the grid
  PanelGrid panels_;
};

}  // namespace talus
