#include "widgets/view/compared_viewport.hpp"

#include <QToolButton>

#include <vtkRenderer.h>

#include "session/compared_results.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

namespace {

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
  if (mouse_.takes(*event, *pose, size(), [this](const CameraPose& to) { viewport_.moveTo(to); })) return true;
  return QFrame::eventFilter(watched, event);
}

}  // namespace talus
