#pragma once

#include <QOpenGLWidget>
#include <QTimer>
#include <functional>
#include <memory>

#include <vtkSmartPointer.h>

#include "render/gl/render_window.hpp"

namespace talus {

/// A widget that a RenderWindow draws into.
class RenderSurface {
 public:
  virtual ~RenderSurface() = default;
  virtual QWidget* widget() = 0;
  RenderWindow& window() { return *window_; }
  /// Draws again soon; many requests make one drawing.
  virtual void requestRender() = 0;
  /// As it is to be seen now, with all that was requested.
  virtual QPixmap picture() = 0;
  /// What lies over the view, and is painted with it.
  void setOver(QWidget& over) { over_ = &over; }
  /// Makes the surface's context current, to take a renderer out of the window.
  virtual void makeContextCurrent() = 0;
  /// Draws a scene for nobody, so that shaders are compiled and letters cut before a first drawing is waited for.
  /// Where a card's driver draws, nothing happens: there is no OpenGL before the widget is shown, and no wait.
  virtual void warmUp(vtkRenderer&) {}
  /// Called after each drawing.
  void setDrawn(std::function<void()> drawn) { drawn_ = std::move(drawn); }
  /// s, of the last drawing.
  double lastSeconds() const { return lastSeconds_; }
  int drawings() const { return drawings_; }

 protected:
  void drawAndTime();
  void fitWindowTo(const QWidget& widget);
  void paintWithWhatLiesOver();

  vtkSmartPointer<RenderWindow> window_ = vtkSmartPointer<RenderWindow>::New();

 private:
  QWidget* over_ = nullptr;
  std::function<void()> drawn_;
  double lastSeconds_ = 0;
  int drawings_ = 0;
};

/// Where Qt has OpenGL: the driver draws.
class GlSurface : public QOpenGLWidget, public RenderSurface {
  Q_OBJECT
 public:
  explicit GlSurface(QWidget* parent);
  ~GlSurface() override;
  QWidget* widget() override { return this; }
  void requestRender() override { paintWithWhatLiesOver(); }
  QPixmap picture() override { return grab(); }
  void makeContextCurrent() override { makeCurrent(); }

 protected:
  void initializeGL() override;
  void resizeEvent(QResizeEvent* event) override;
  void resizeGL(int width, int height) override;
  void paintGL() override;

 private:
  void release();
  std::unique_ptr<GlContext> context_;
  QSizeF pixels_;  ///< that Qt was last asked to make room for
};

/// Everywhere else (no X server, the `offscreen` platform): OSMesa draws a picture and the widget shows it. Drawing is
/// the processor's work and has an event of its own, so that keys and the mouse are heard between it and the painting
/// of the rest of the window.
class ImageSurface : public QWidget, public RenderSurface {
  Q_OBJECT
 public:
  explicit ImageSurface(QWidget* parent);
  ~ImageSurface() override;
  QWidget* widget() override { return this; }
  void requestRender() override;
  QPixmap picture() override;
  void makeContextCurrent() override;
  void warmUp(vtkRenderer& renderer) override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void draw();
  std::unique_ptr<GlContext> context_;
  QImage picture_;
  QTimer soon_;
  bool stale_ = true;  ///< repaints of overlays do not draw the scene again
};

/// The kind that works on this platform, as a child of `parent`, which owns it.
RenderSurface* makeRenderSurface(QWidget* parent);

/// Qt's part of talking to VTK; before QApplication is made.
void setDefaultSurfaceFormat();

}  // namespace talus
