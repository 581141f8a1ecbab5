#include "widgets/view/render_surface.hpp"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QPainter>
#include <QResizeEvent>
#include <QSurfaceFormat>

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <array>

namespace talus {

void RenderSurface::drawAndTime() {
  QElapsedTimer timer;
  timer.start();
  window_->Render();
  lastSeconds_ = static_cast<double>(timer.nsecsElapsed()) * 1e-9;
  ++drawings_;
  if (drawn_) drawn_();
}

void RenderSurface::fitWindowTo(const QWidget& widget) {
  const double ratio = widget.devicePixelRatioF();
  window_->SetSize(qMax(1, qRound(widget.width() * ratio)), qMax(1, qRound(widget.height() * ratio)));
}

void RenderSurface::paintWithWhatLiesOver() {
  widget()->update();
  if (over_) over_->update();
}

namespace {

class QtContext final : public GlContext {
 public:
  explicit QtContext(QOpenGLWidget& widget) : widget_(widget) {}
  bool make_current() override {
    if (!is_current()) widget_.makeCurrent();
    return is_current();
  }
  void done_current() override { widget_.doneCurrent(); }
  bool is_current() const override {
    return widget_.context() != nullptr && QOpenGLContext::currentContext() == widget_.context();
  }
  std::string name() const override { return "Qt"; }

 private:
  QOpenGLWidget& widget_;
};

}  // namespace

GlSurface::GlSurface(QWidget* parent) : QOpenGLWidget(parent), context_(std::make_unique<QtContext>(*this)) {
  setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
}

GlSurface::~GlSurface() {
  release();
  // The context goes after this has gone, and would tell of it.
  if (context() != nullptr) context()->disconnect(this);
}

void GlSurface::initializeGL() {
  // Floating or docking the view gives it a new context: everything on the card goes with the old one.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlSurface::release, Qt::UniqueConnection);
  window_->set_context(*context_);
}

void GlSurface::release() {
  if (context() == nullptr || !window_->GetReadyForRendering()) return;
  makeCurrent();
  window_->release_context();
  doneCurrent();
}

/// A view that was resized and back while it was hidden gets an event as well. Qt 6.4 would make another texture, and
/// go on showing the one before, whose place the rest of the window takes.
void GlSurface::resizeEvent(QResizeEvent* event) {
  const QSizeF pixels = QSizeF(event->size()) * devicePixelRatioF();
  if (isValid() && pixels == pixels_) return;
  pixels_ = pixels;
  QOpenGLWidget::resizeEvent(event);
}

void GlSurface::resizeGL(int, int) { fitWindowTo(*this); }

void GlSurface::paintGL() {
  drawAndTime();
  makeCurrent();  // drawing may have left another context current
  auto* gl = context()->extraFunctions();
  const int* size = window_->GetSize();
  const double ratio = devicePixelRatioF();
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  const GLenum target = GL_COLOR_ATTACHMENT0;
  gl->glDrawBuffers(1, &target);
  gl->glDisable(GL_SCISSOR_TEST);
  window_->BlitDisplayFramebuffer(0, 0, 0, size[0], size[1], 0, 0, qRound(width() * ratio), qRound(height() * ratio),
                                  GL_COLOR_BUFFER_BIT, GL_NEAREST);
  // The picture's alpha must be 1, or the desktop shows through the window.
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

ImageSurface::ImageSurface(QWidget* parent) : QWidget(parent), context_(make_offscreen_context()) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  window_->set_context(*context_);
  context_->done_current();
  constexpr int soon = 10;  // ms: after what waits already, so that a key is not heard later by a whole drawing
  soon_.setInterval(soon);
  soon_.setSingleShot(true);
  connect(&soon_, &QTimer::timeout, this, [this] {
    if (!isVisible()) return;  // drawn when it is shown
    draw();
    paintWithWhatLiesOver();
  });
}

ImageSurface::~ImageSurface() {
  window_->release_context();
  context_->done_current();
}

void ImageSurface::requestRender() {
  stale_ = true;
  soon_.start();
}

QPixmap ImageSurface::picture() {
  soon_.stop();
  return grab();
}

void ImageSurface::makeContextCurrent() { context_->make_current(); }

void ImageSurface::warmUp(vtkRenderer& renderer) {
  constexpr int side = 65;  // no power of two: software compiles shaders for those and for all others
  const std::array<int, 2> size{window_->GetSize()[0], window_->GetSize()[1]};
  window_->SetSize(side, side);
  window_->AddRenderer(&renderer);
  window_->Render();
  window_->RemoveRenderer(&renderer);
  window_->SetSize(size[0], size[1]);
  context_->done_current();
}

void ImageSurface::resizeEvent(QResizeEvent*) {
  fitWindowTo(*this);
  stale_ = true;
  if (picture_.isNull())
    soon_.start();
  else
    soon_.stop();  // a picture of another size is not worth showing meanwhile
}

void ImageSurface::draw() {
  stale_ = false;
  drawAndTime();
  const int* size = window_->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window_->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  picture_ = QImage(pixels->GetPointer(0), size[0], size[1], size[0] * 4, QImage::Format_RGBX8888).mirrored();
  picture_.setDevicePixelRatio(devicePixelRatioF());
  context_->done_current();  // Qt may use OpenGL of its own on this thread
}

void ImageSurface::paintEvent(QPaintEvent*) {
  if (stale_ && !soon_.isActive()) draw();
  QPainter painter(this);
  if (picture_.isNull()) painter.fillRect(rect(), palette().window());
  painter.drawImage(QPoint(0, 0), picture_);
}

RenderSurface* makeRenderSurface(QWidget* parent) {
  static const bool hasOpenGl = [] {
    // These platforms have no QOpenGLWidget, though a context can sometimes be made.
    const QString platform = QGuiApplication::platformName();
    if (platform == QLatin1String("offscreen") || platform == QLatin1String("vnc") ||
        platform == QLatin1String("minimal"))
      return false;
    return QOpenGLContext().create();
  }();
  if (hasOpenGl) return new GlSurface(parent);
  return new ImageSurface(parent);
}

void setDefaultSurfaceFormat() {
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setAlphaBufferSize(0);
  format.setSamples(0);  // VTK smooths edges itself
  QSurfaceFormat::setDefaultFormat(format);
}

}  // namespace talus
