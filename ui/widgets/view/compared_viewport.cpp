#include "widgets/view/compared_viewport.hpp"

#include <QGridLayout>
#include <QToolButton>
#include <algorithm>

#include <vtkRenderer.h>

#include "widgets/kit/parts.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

namespace {

constexpr int without_delay = 0;  // ms

}  // namespace

SceneSettings settingsBeside(const SceneSettings& view, const std::string& name) {
  SceneSettings settings = view;
  settings.title = name;
  settings.legend = settings.triad = settings.scale_bar = false;  // the view beside it has the same
  settings.places.clear();                                        // those are of the other's blocks
  settings.block_colours.reset();
  return settings;
}

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
  connect(over_, &QToolButton::toggled, this, &ComparedViewport::drawOver);
  surface_->widget()->setAccessibleName(tr("The results that are compared"));
  surface_->widget()->installEventFilter(this);
  connect(run_.get(), &ComparedRun::frameChanged, this, &ComparedViewport::follow);
  connect(run_.get(), &ComparedRun::frameChanged, this, [this] {
    if (over_->isChecked()) drawOver();
  });
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
  over_->setChecked(false);
  hide();
  deleteLater();
}

void ComparedViewport::make() {
  const auto work = [index = run_->results(), settings = viewport_.screenSettings()](Progress&) {
    return std::make_shared<Scene>(*index->system, settings);
  };
  drawing_.begin(work, [this](const std::shared_ptr<Scene>& scene) {
    scene_ = scene;
    surface_->window().AddRenderer(scene_->renderer());
    follow();
  });
}

/// Draws what the view beside it shows, in these results.
void ComparedViewport::follow() {
  const auto pose = viewport_.pose();
  if (!scene_ || !pose) return;
  SceneSettings settings = settingsBeside(viewport_.screenSettings(), all_.nameOf(*run_).toStdString());
  if (!viewport_.showsField()) settings.field.reset();
  settings.parallel_projection = pose->parallel;
  scene_->set_settings(settings);
  if (run_->frame()) scene_->set_frame(run_->frame());
  scene_->set_pose(*pose);
  surface_->requestRender();
}

void ComparedViewport::drawOver() {
  if (!over_->isChecked()) return viewport_.setGhost({});
  if (run_->frame()) viewport_.setGhost({run_->results()->system, run_->frame(), all_.nameOf(*run_).toStdString()});
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

ComparedViewports::ComparedViewports(ComparedResults& all, Viewport& viewport, QGridLayout& grid)
    : QObject(&viewport), all_(all), viewport_(viewport), grid_(grid) {
  arrange();
  grid_.parentWidget()->installEventFilter(this);
  connect(&all, &ComparedResults::changed, this, &ComparedViewports::follow);
}

bool ComparedViewports::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) arrange();
  return QObject::eventFilter(watched, event);
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
    views_.insert(views_.begin() + static_cast<std::ptrdiff_t>(i), new ComparedViewport(all_, runs[i], viewport_));
  }
  arrange();
}

void ComparedViewports::arrange() {
  std::vector<QWidget*> shown{&viewport_};
  shown.insert(shown.end(), views_.begin(), views_.end());
  const QSize all = grid_.parentWidget()->size();
  const int count = static_cast<int>(shown.size());
  const PanelGrid panels = panel_grid(count, all.width(), all.height());
  if (shown == shown_ && panels == panels_) return;
  shown_ = shown;
  panels_ = panels;
  const int columns = panels.columns;
  while (grid_.count() > 0) delete grid_.takeAt(0);
  for (int column = 0; column < grid_.columnCount(); ++column) grid_.setColumnStretch(column, 0);
  for (int row = 0; row < grid_.rowCount(); ++row) grid_.setRowStretch(row, 0);
  for (int i = 0; i < count; ++i) {
    const int row = i / columns, column = i % columns;
    grid_.addWidget(shown[static_cast<std::size_t>(i)], row, column, 1, i + 1 < count ? 1 : columns - column);
    grid_.setColumnStretch(column, 1);
    grid_.setRowStretch(row, 1);
  }
}

}  // namespace talus
