#include "widgets/view/solid_viewport.hpp"

#include <vtkRenderer.h>

#include "geometry/solid_surface.hpp"
#include "render/scene/slope_view.hpp"
#include "session/solid_surfaces.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/view/render_surface.hpp"

namespace talus {

namespace {

constexpr int rested_ms = 300;  // after that it is drawn finely
constexpr int at_once = 0;      // ms

}  // namespace

SolidViewport::SolidViewport(QWidget* parent) : QWidget(parent), surface_(makeRenderSurface(this)), drawing_(at_once) {
  setMinimumSize(320, 240);
  surface_->widget()->setAccessibleName(tr("Preview of the solid"));
  surface_->widget()->installEventFilter(this);
  surface_->widget()->hide();
  stillTimer_.setSingleShot(true);
  stillTimer_.setInterval(rested_ms);
  connect(&stillTimer_, &QTimer::timeout, this, [this] { draw(true); });
}

SolidViewport::~SolidViewport() { takeAway(); }

void SolidViewport::clear() {
  drawing_.cancel();
  takeAway();
}

void SolidViewport::takeAway() {
  if (!scene_) return;
  surface_->makeContextCurrent();  // the card's memory is freed as the renderer leaves
  surface_->window().RemoveRenderer(scene_->renderer());
  scene_.reset();
  surface_->widget()->hide();
}

void SolidViewport::setSolid(const SolidSurface& solid, bool anew) {
  anew_ = anew_ || anew;
  SceneSettings settings;
  settings.theme = theme::now().dark ? Theme::dark : Theme::light;
  settings.legend = settings.time_stamp = settings.smooth_outlines = false;
  settings.text_height = theme::now().type.small * devicePixelRatioF();
  settings.places = oddPlaces(solid);
  const auto draw = [solid, settings](Progress&) {
    auto system = std::make_shared<const BlockSystem>(
        BlockSystem{.blocks = {surfaceBlock(solid, 0, BodyKind::tetrahedra)}, .joint_names = {}});
    auto scene = std::make_shared<Scene>(*system, settings);
    look_at_slope(*scene, *system, nullptr);
    return Drawn{std::move(system), std::move(scene)};
  };
  drawing_.begin(draw, [this](const Drawn& made) { show(made); });
}

void SolidViewport::show(const Drawn& made) {
  const auto standing = scene_ && moved_ && !anew_ ? std::optional(scene_->pose()) : std::nullopt;
  takeAway();
  system_ = made.system;
  scene_ = made.scene;
  surface_->window().AddRenderer(scene_->renderer());
  anew_ = false;
  moved_ = standing.has_value();
  if (standing) scene_->set_pose(*standing);
  surface_->widget()->show();
  draw(true);
}

void SolidViewport::fit() {
  moved_ = false;
  scene_->fit();
  draw(true);
}

void SolidViewport::draw(bool fine) {
  if (!scene_) return;
  SceneSettings settings = scene_->settings();
  settings.fine = fine;
  scene_->set_settings(settings);
  surface_->requestRender();
}

void SolidViewport::moveCamera(const CameraPose& pose) {
  moved_ = true;
  scene_->set_pose(pose);
  if (scene_->settings().fine)
    draw(false);
  else
    surface_->requestRender();
  stillTimer_.start();
}

void SolidViewport::resizeEvent(QResizeEvent*) {
  surface_->widget()->setGeometry(rect());
  if (scene_ && !moved_) fit();
}

bool SolidViewport::eventFilter(QObject* watched, QEvent* event) {
  if (watched != surface_->widget() || !scene_) return QWidget::eventFilter(watched, event);
  if (mouse_.takes(*event, scene_->pose(), size(), [this](const CameraPose& to) { moveCamera(to); })) return true;
  if (event->type() != QEvent::MouseButtonDblClick) return QWidget::eventFilter(watched, event);
  fit();
  return true;
}

}  // namespace talus
