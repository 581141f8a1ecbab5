#include "widgets/view/compared_viewport.hpp"

#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include <vtkRenderer.h>

#include "render/paint/panel_grid.hpp"
#include "render/paint/theme.hpp"
#include "render/views/view_of_results.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

namespace {

constexpr int without_delay = 0;  // ms

}  // namespace

ComparedViewport::ComparedViewport(ComparedResults& all, std::shared_ptr<ComparedRun> run, Viewport& viewport)
    : all_(all),
      run_(std::move(run)),
      viewport_(viewport),
      surface_(makeRenderSurface(this)),
      end_(makeTool(QStringLiteral("close"), tr("End comparing"))),
      over_(makeTool(QStringLiteral("copy"), tr("Draw its blocks' edges over the view beside it"), true)),
      drawing_(without_delay) {
  for (QToolButton* tool : {end_, over_}) {
    tool->setParent(this);
    tool->raise();
  }
  connect(end_, &QToolButton::clicked, this, [this] { all_.close(*run_); });
  connect(over_, &QToolButton::toggled, this, [this](bool over) { all_.setOver(*run_, over); });
  connect(&all_, &ComparedResults::overChanged, this, &ComparedViewport::drawOver);
  surface_->widget()->setAccessibleName(tr("The results that are compared"));
  surface_->widget()->installEventFilter(this);
  connect(run_.get(), &ComparedRun::frameChanged, this, &ComparedViewport::follow);
  connect(run_.get(), &ComparedRun::frameChanged, this, &ComparedViewport::drawOver);
  connect(&all_, &ComparedResults::changed, this, &ComparedViewport::follow);  // its name may be another
  connect(&viewport, &Viewport::redrawn, this, &ComparedViewport::follow);
  make();
}

ComparedViewport::~ComparedViewport() {
  if (!scene_) return;
  surface_->makeContextCurrent();  // the card's memory is freed as the renderer leaves
  surface_->window().RemoveRenderer(scene_->renderer());
}

void ComparedViewport::end() {
  all_.disconnect(this);
  hide();
  deleteLater();
}

void ComparedViewport::make() {
  drawOver();  // it may have been asked for before
  const auto work = [index = run_->results(), settings = viewport_.screenSettings()](Progress&) {
    return std::make_shared<Scene>(*index->system, settings);
  };
  drawing_.begin(work, [this](const std::shared_ptr<Scene>& scene) {
    scene_ = scene;
    scene_->set_stage_names(run_->results()->stage_names);
    surface_->window().AddRenderer(scene_->renderer());
    follow();
  });
}

/// Draws what the view beside it shows, in these results.
void ComparedViewport::follow() {
  const auto pose = viewport_.pose();
  if (!scene_ || !pose) return;
  SceneSettings settings = settings_beside(viewport_.screenSettings(), all_.nameOf(*run_).toStdString());
  if (!viewport_.showsField()) settings.field.reset();
  settings.parallel_projection = pose->parallel;
  scene_->set_settings(settings);
  if (run_->frame()) scene_->set_frame(run_->frame());
  scene_->set_rock_area(viewport_.rockArea());
  scene_->set_pose(*pose);
  surface_->requestRender();
}

void ComparedViewport::drawOver() {
  const bool over = all_.isOver(*run_), was = std::exchange(isOver_, over);
  const QSignalBlocker quiet(over_);
  over_->setChecked(over);
  if (over && run_->frame())
    viewport_.setGhost({run_->results()->system, run_->frame(), all_.nameOf(*run_).toStdString()});
  else if (was && !all_.isAnyOver())  // else that one draws its own
    viewport_.setGhost({});
}

void ComparedViewport::resizeEvent(QResizeEvent*) {
  constexpr int away = 8;  // pixels, of the buttons
  surface_->widget()->setGeometry(rect());
  end_->move(width() - end_->sizeHint().width() - away, away);
  over_->move(end_->x(), end_->y() + end_->sizeHint().height() + away / 2);
  follow();
}

bool ComparedViewport::eventFilter(QObject* watched, QEvent* event) {
  const auto pose = viewport_.pose();
  if (watched != surface_->widget() || !scene_ || !pose) return QFrame::eventFilter(watched, event);
  if (mouse_.takes(*event, *pose, size(), [this](const CameraPose& to) { viewport_.moveTo(to); })) return true;
  return QFrame::eventFilter(watched, event);
}

ComparedViewports::ComparedViewports(ComparedResults& all, Viewport& viewport) : all_(all), viewport_(viewport) {
  viewport_.setParent(this);
  setMinimumSize(viewport_.minimumSize());
  connect(&all, &ComparedResults::changed, this, &ComparedViewports::follow);
}

void ComparedViewports::resizeEvent(QResizeEvent*) { arrange(); }

/// The lines between views, as in pictures of several results; one alone has what is behind the window's parts.
void ComparedViewports::paintEvent(QPaintEvent*) {
  if (views_.empty()) return;
  const Rgb line = colours(viewport_.screenSettings().theme).frame;
  QPainter(this).fillRect(rect(), QColor(line.red, line.green, line.blue));
}

void ComparedViewports::follow() {
  const auto& runs = all_.runs();
  std::erase_if(views_, [&](ComparedViewport* view) {
    const bool stays = std::ranges::any_of(runs, [view](const auto& run) { return run.get() == &view->run(); });
    if (!stays) view->end();
    return !stays;
  });
  for (std::size_t i = 0; i < runs.size(); ++i) {  // in their order, whichever came first
    if (i < views_.size() && &views_[i]->run() == runs[i].get()) continue;
    auto* view = new ComparedViewport(all_, runs[i], viewport_);
    view->setParent(this);
    view->show();
    views_.insert(views_.begin() + static_cast<std::ptrdiff_t>(i), view);
  }
  arrange();
}

void ComparedViewports::arrange() {
  const int count = static_cast<int>(views_.size()) + 1;
  const std::vector<PanelPlace> places = panel_places(count, width(), height());
  for (int i = 0; i < count; ++i) {
    const PanelPlace& place = places[static_cast<std::size_t>(i)];
    QWidget* view = i == 0 ? static_cast<QWidget*>(&viewport_) : views_[static_cast<std::size_t>(i - 1)];
    view->setGeometry(place.left, place.top, place.width, place.height);
  }
}

}  // namespace talus
