#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <vector>

#include "jobs/latest_job.hpp"
#include "render/scene/scene.hpp"
#include "widgets/view/camera_moves.hpp"

namespace talus {

class RenderSurface;
struct SolidSurface;

/// A small 3-D view of a solid that is in no project yet, for dialogs: left drag turns it, middle drag moves it, the
/// wheel zooms, a double click shows all of it. What is odd in its surface is marked where it is.
class SolidViewport : public QWidget {
  Q_OBJECT
 public:
  explicit SolidViewport(QWidget* parent = nullptr);
  ~SolidViewport() override;

  /// It is in view as soon as it can be drawn, what was there before stays until then. The camera stays where it is
  /// unless `anew`.
  void setSolid(const SolidSurface& solid, bool anew);
  void clear();
  bool isEmpty() const { return scene_ == nullptr; }
  const RenderSurface& surface() const { return *surface_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Drawn {
    std::shared_ptr<const BlockSystem> system;  ///< the scene keeps a reference
    std::shared_ptr<Scene> scene;
  };
  void show(const Drawn& made);
  void takeAway();
  void moveCamera(const CameraPose& pose);
  void fit();
  void draw(bool fine);

  RenderSurface* surface_;
  std::shared_ptr<const BlockSystem> system_;  ///< what scene_ draws
  std::shared_ptr<Scene> scene_;
  QTimer stillTimer_;  ///< fires when the camera has rested
  CameraMouse mouse_{0.4};
  bool moved_ = false;  ///< by hand since it was fitted
  bool anew_ = false;   ///< what comes is looked at anew
  LatestJob drawing_;
};

}  // namespace talus
