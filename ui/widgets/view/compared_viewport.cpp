#include "widgets/view/compared_viewport.hpp"

#include <QMouseEvent>
#include <QToolButton>
#include <QWheelEvent>

#include <vtkRenderer.h>

#include <cmath>

#include "session/compared_results.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/view/camera_moves.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

namespace {

constexpr double degrees_of_pixel = 0.35;  // as in the view beside it
constexpr double nearer_of_notch = 0.85;
constexpr int without_delay = 0;  // ms

}  // namespace

ComparedViewport::ComparedViewport(ComparedResults& results, Viewport& viewport)
    : results_(results),
      viewport_(viewport),
      surface_(makeRenderSurface(this)),
      end_(makeTool(QStringLiteral("close"), tr("End comparing"))),
      drawing_(without_delay) {
  end_->setParent(this);
  connect(end_, &QToolButton::clicked, &results, &ComparedResults::close);
  end_->raise();
  surface_->widget()->setAccessibleName(tr("The results that are compared"));
  surface_->widget()->installEventFilter(this);
  connect(&results, &ComparedResults::changed, this, &ComparedViewport::takeResults);
  connect(&results, &ComparedResults::frameChanged, this, &ComparedViewport::follow);
  connect(&viewport, &Viewport::redrawn, this, &ComparedViewport::follow);
  hide();
}

ComparedViewport::~ComparedViewport() { takeAway(); }

void ComparedViewport::takeAway() {
  if (!scene_) return;
  surface_->makeContextCurrent();  // the card's memory is freed as the renderer leaves
  surface_->window().RemoveRenderer(scene_->renderer());
  scene_.reset();
}

void ComparedViewport::takeResults() {
  takeAway();
  drawing_.cancel();
  shown_ = results_.results();
  setVisible(shown_ != nullptr);
  if (!shown_) return;
  const auto make = [index = shown_, settings = viewport_.screenSettings()](Progress&) {
    return std::make_shared<Scene>(*index->system, settings);
  };
  drawing_.begin(make, [this](const std::shared_ptr<Scene>& scene) {
    scene_ = scene;
    scene_->set_stage_names(shown_->stage_names);
    surface_->window().AddRenderer(scene_->renderer());
    follow();
  });
}

/// Draws what the view beside it shows, in these results.
void ComparedViewport::follow() {
  const auto pose = viewport_.pose();
  if (!scene_ || !pose) return;
  SceneSettings settings = viewport_.screenSettings();
  if (!viewport_.showsField()) settings.field.reset();
  settings.parallel_projection = pose->parallel;
  settings.title = results_.name().toStdString();
  settings.legend = false;  // the view beside it has the same
  settings.places.clear();  // those are of the other's blocks
  settings.block_colours.reset();
  scene_->set_settings(settings);
  if (results_.frame()) scene_->set_frame(results_.frame());
  scene_->set_pose(*pose);
  surface_->requestRender();
}

void ComparedViewport::resizeEvent(QResizeEvent*) {
  constexpr int away = 8;  // pixels, of the button
  surface_->widget()->setGeometry(rect());
  end_->move(width() - end_->sizeHint().width() - away, away);
  follow();
}

bool ComparedViewport::eventFilter(QObject* watched, QEvent* event) {
  const auto pose = viewport_.pose();
  if (watched != surface_->widget() || !scene_ || !pose) return QFrame::eventFilter(watched, event);
  if (event->type() == QEvent::MouseButtonPress) {
    last_ = static_cast<QMouseEvent*>(event)->position();
    return true;
  }
  if (event->type() == QEvent::MouseMove) {
    const auto& mouse = *static_cast<QMouseEvent*>(event);
    const QPointF by = mouse.position() - last_;
    last_ = mouse.position();
    if (mouse.buttons().testFlag(Qt::LeftButton))
      viewport_.moveTo(turned(*pose, -by.x() * degrees_of_pixel, by.y() * degrees_of_pixel));
    else if (mouse.buttons().testFlag(Qt::MiddleButton))
      viewport_.moveTo(panned(*pose, by, size()));
    return true;
  }
  if (event->type() == QEvent::Wheel) {
    const auto& wheel = *static_cast<QWheelEvent*>(event);
    const double notches = wheel.angleDelta().y() / 120.0;
    viewport_.moveTo(zoomed(*pose, std::pow(nearer_of_notch, notches), wheel.position(), size()));
    return true;
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace talus
