#pragma once

#include <QFrame>
#include <memory>

#include "jobs/latest_job.hpp"
#include "render/scene/scene.hpp"
#include "widgets/view/camera_moves.hpp"

class QToolButton;

namespace talus {

class ComparedResults;
class RenderSurface;
class Viewport;

/// Beside the view: the results that are compared, at the same moment, from the same place and in the same colours.
/// Either camera is moved by the other's: left drag turns, middle drag pans, the wheel zooms. Hidden while nothing is
/// compared.
class ComparedViewport : public QFrame {
  Q_OBJECT
 public:
  ComparedViewport(ComparedResults& results, Viewport& viewport);
  ~ComparedViewport() override;

  /// Null until the blocks can be drawn.
  const Scene* scene() const { return scene_.get(); }
  RenderSurface& surface() { return *surface_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void takeResults();
  void follow();
  void takeAway();

  ComparedResults& results_;
  Viewport& viewport_;
  RenderSurface* surface_;
  QToolButton* end_;
  std::shared_ptr<const ResultsIndex> shown_;  ///< whose blocks scene_ draws
  std::shared_ptr<Scene> scene_;
  CameraMouse mouse_{0.35};  // as in the view beside it
  LatestJob drawing_;        ///< last: its thread ends before the others go
};

}  // namespace talus
