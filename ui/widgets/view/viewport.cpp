#include "widgets/view/viewport.hpp"

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QRubberBand>

#include <vtkRenderer.h>

#include <algorithm>
#include <tuple>

#include "geometry/solid_surface.hpp"
#include "jobs/solver_job.hpp"
#include "render/paint/painter.hpp"
#include "session/session.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/view/lasso.hpp"
#include "widgets/view/place_picker.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/view_overlay.hpp"

namespace talus {

namespace {

constexpr int still_ms = 350;       // after that the view is drawn finely
constexpr int live_pause_ms = 125;  // between drawings while a run goes on: eight a second at most
constexpr double live_share = 0.2;  // of the window's time that drawing may take then
constexpr int hover_ms = 40;
constexpr double told_seconds = 2;         // time left that is worth a word
constexpr double rock_with_joints = 0.22;  // opacity of rock that joints are seen through
constexpr double apart = 0.6;              // of their way from the middle: as far as blocks are drawn from each other
constexpr int no_pause = 0;                // before blocks that have come are made ready to be drawn
constexpr int flight_ms = 450;             // from where the camera stands to a place that was asked for

}  // namespace

Viewport::Viewport(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), surface_(makeRenderSurface(this)), drawing_(no_pause) {
  setMinimumSize(280, 180);
  QWidget* area = surface_->widget();
  area->setMouseTracking(true);
  area->setFocusPolicy(Qt::StrongFocus);
  area->setAccessibleName(tr("3-D view"));
  area->setObjectName(QStringLiteral("view area"));
  area->installEventFilter(this);
  area->hide();

  band_ = new QRubberBand(QRubberBand::Rectangle, area);
  lasso_ = new Lasso(area);

  overlay_ = new ViewOverlay(this);
  surface_->setOver(*overlay_);
  surface_->setDrawn([this] { tellOfFit(); });
  tools_ = makePlane("overlay");
  tools_->setParent(this);
  setMargins(new QVBoxLayout(tools_), 3, 1);

  card_ = makePlane("overlay");
  card_->setParent(this);
  auto* cardLayout = new QVBoxLayout(card_);
  cardLayout->setContentsMargins(10, 6, 10, 7);
  cardLayout->setSpacing(1);
  cardTitle_ = makeLabel({}, "strong");
  cardText_ = makeLabel({}, "small");
  cardLayout->addWidget(cardTitle_);
  cardLayout->addWidget(cardText_);
  card_->setAttribute(Qt::WA_TransparentForMouseEvents);
  card_->hide();

  empty_ = new QWidget(this);
  auto* emptyLayout = new QVBoxLayout(empty_);
  setMargins(emptyLayout, 0, 12);
  emptyText_ = makeLabel({}, "muted");
  emptyText_->setAlignment(Qt::AlignCenter);
  emptyButton_ = makeButton(tr("Cut and mesh"));
  connect(emptyButton_, &QPushButton::clicked, this, [this] {
    if (session_.run.job().isBusy())
      session_.run.job().stop();
    else if (session_.project.document().isOpen())
      hasRock() ? session_.run.mesh() : emit rockWanted();
  });
  emptyLayout->addWidget(emptyText_);
  emptyLayout->addWidget(emptyButton_, 0, Qt::AlignHCenter);

  picker_ = new PlacePicker(session_.picking, *this);
  overlay_->add(*picker_);

  stillTimer_.setSingleShot(true);
  stillTimer_.setInterval(still_ms);
  connect(&stillTimer_, &QTimer::timeout, this, &Viewport::becomeStill);
  drawTimer_.setSingleShot(true);
  connect(&drawTimer_, &QTimer::timeout, this, &Viewport::drawNow);
  hoverTimer_.setSingleShot(true);
  hoverTimer_.setInterval(hover_ms);
  connect(&hoverTimer_, &QTimer::timeout, this, &Viewport::pickForHover);

  flight_.setDuration(flight_ms);
  flight_.setEasingCurve(QEasingCurve::InOutCubic);
  flight_.setStartValue(0.0);
  flight_.setEndValue(1.0);
  connect(&flight_, &QVariantAnimation::valueChanged, this, [this](const QVariant& share) {
    if (scene_) moveCamera(between(flightStart_, flightEnd_, share.toDouble()));
  });

  connect(&session_.run, &CurrentRun::troublesChanged, this, &Viewport::applyTroubles);
  connect(&session_.trails, &MeasuredTrails::changed, this, &Viewport::applyTrails);
  connect(&session_.display, &Display::troubleWanted, this, [this](const ConvergenceTrouble& trouble) {
    if (scene_) flyTo(scene_->pose_at(trouble));
  });
  connect(&session_.display, &Display::placeWanted, this, [this](const MarkedPlace& place) {
    if (scene_) flyTo(scene_->pose_at(place));
  });
  connect(&session_.project, &CurrentProject::systemChanged, this, &Viewport::followSystem);
  connect(&session_.surfaces, &SolidSurfaces::changed, this, &Viewport::followSystem);
  connect(&session_.display, &Display::pageChanged, this, &Viewport::followSystem);
  connect(&session_.project.document(), &Document::projectChanged, this, &Viewport::followSystem);
  connect(&session_.playback, &Playback::frameChanged, this, &Viewport::showFrame);
  connect(&session_.display, &Display::changed, this, &Viewport::takeDisplay);
  connect(&session_.compared, &ComparedResults::changed, this, &Viewport::applySettings);
  connect(&session_.run, &CurrentRun::progressed, this, &Viewport::showEmptyState);
  connect(&session_.project, &CurrentProject::opened, this, [this] {
    standing_.reset();
    if (session_.display.settings().section) toggleSection();
  });
  connect(&session_.project, &CurrentProject::opened, this, &Viewport::showEmptyState);
  // Places that were taken would be of blocks that are there no longer.
  connect(&session_.project, &CurrentProject::opened, &session_.picking, &Picking::cancel);
  connect(&session_.project, &CurrentProject::systemChanged, &session_.picking, &Picking::cancel);
  connect(&session_.run.job(), &SolverJob::stateChanged, this, [this] {
    showEmptyState();
    stillTimer_.start();
  });
  connect(&session_.project.selection(), &Selection::changed, this, &Viewport::applySelection);
  connect(&session_.project.selection(), &Selection::changed, this, &Viewport::applyJoints);
  connect(&session_.joints, &DrawnJoints::changed, this, &Viewport::applyJoints);
  connect(&session_.display, &Display::pageChanged, this, &Viewport::drawRoughlyFirst);
  connect(&session_.display, &Display::pageChanged, this, &Viewport::applyJoints);
  connect(&session_.display, &Display::changed, this, &Viewport::followSystem);
  connect(&session_.display, &Display::changed, this, &Viewport::applyJoints);
  connect(&session_.project.selection(), &Selection::changed, this, &Viewport::applyActions);
  connect(&session_.project.document(), &Document::projectChanged, this, &Viewport::applyActions);
  connect(&session_.display, &Display::pageChanged, this, &Viewport::applyActions);
  connect(&session_.project.selection(), &Selection::hoverChanged, this, [this] {
    if (!scene_) return;
    scene_->set_hovered(hoveredInView());
    render();
  });
  showScene({});
}

/// Blocks, once they are cut; where they are to be cut anew the Geometry page shows the solids that they will be cut
/// from, and joints are drawn in the solids.
std::shared_ptr<const BlockSystem> Viewport::wantedSystem() const {
  const auto blocks = session_.project.system();
  const bool isToBeCut = session_.display.page() == WorkflowPage::geometry && !session_.project.systemIsCurrent();
  const bool ofSolids = isToBeCut || showsJoints();
  if (blocks && !ofSolids && !session_.surfaces.isProposal()) return blocks;
  const auto solids = session_.surfaces.asBlocks();
  return solids ? solids : blocks;
}

/// What is drawn of many blocks takes a moment to make: those before stay in view meanwhile.
void Viewport::followSystem() {
  const auto wanted = wantedSystem();
  if (wanted == wanted_) return showEmptyState();
  wanted_ = wanted;
  drawing_.cancel();
  card_->hide();
  const auto known = std::ranges::find(made_, wanted, &Drawn::system);
  const bool areSolids = wanted != session_.project.system();
  const auto solids = areSolids ? session_.surfaces.jointed() : std::make_shared<const std::vector<JointedRock>>();
  if (!wanted)
    showScene({});
  else if (known != made_.end())
    showScene(Drawn(*known));
  else if (isMadeAtOnce(*wanted))
    showScene(drawn(wanted, session_.display.settings(), *solids));
  else
    drawing_.begin([wanted, solids,
                    settings = session_.display.settings()](Progress&) { return drawn(wanted, settings, *solids); },
                   [this](const Drawn& made) { showScene(made); });
}

/// The camera stays where it is as long as it is the same project; only other solids than before are looked at anew.
bool Viewport::mayStand(const Drawn& next) const {
  const bool areSolids = next.system != session_.project.system();
  return !(areSolids && showsSolids_ && system_ && system_->blocks.size() != next.system->blocks.size());
}

void Viewport::showScene(const Drawn& next) {
  if (scene_) standing_ = Standing{scene_->pose(), scene_->fits_itself()};
  if (next.scene && !mayStand(next)) standing_.reset();
  flight_.stop();
  card_->hide();
  actions_.clear();
  for (Drawn& one : made_)
    if (one.scene == scene_) one.hidden = hidden_;
  scene_ = next.scene;
  system_ = next.system;
  hidden_ = next.hidden;
  showsSolids_ = system_ != session_.project.system();
  const bool isNew = scene_ && std::ranges::find(made_, system_, &Drawn::system) == made_.end();
  if (isNew) {
    made_.push_back(next);
    surface_->window().AddRenderer(scene_->renderer());
  }
  // The blocks and the solids that they are cut from are looked at in turn.
  keepScenes([this](const Drawn& one) {
    return one.system == system_ || one.system == session_.project.system() ||
           one.system == session_.surfaces.asBlocks();
  });
  for (const Drawn& one : made_) one.scene->renderer()->SetDraw(one.scene == scene_);
  surface_->widget()->setVisible(system_ != nullptr);
  showEmptyState();
  placeOverlays();
  if (!scene_) return;
  scene_->set_stage_names(session_.run.stageNames());
  keepLabelsBesideTools();
  if (standing_)
    takeStanding(*standing_);
  else if (isNew)
    scene_->fit();
  drawRoughlyFirst();
  applySelection();
  applyJoints();
  applyTroubles();
  applyTrails();
  applyActions();
  showFrame();
}

/// Many triangles are drawn finely once they have been drawn.
void Viewport::drawRoughlyFirst() {
  if (!scene_) return;
  still_ = isMadeAtOnce(*system_);
  stillTimer_.start();
  applySettings();
}

std::shared_ptr<const Frame> Viewport::shownFrame() const { return showsSolids_ ? nullptr : session_.playback.frame(); }

void Viewport::showFrame() {
  if (!scene_ || isStale()) return;
  if (const auto frame = shownFrame())
    scene_->set_frame(frame);
  else
    scene_->clear_frame();
  card_->hide();
  applySettings();
}

void Viewport::takeDisplay() {
  const SceneSettings& wanted = session_.display.settings();
  const auto told = [](const SceneSettings& s) { return std::tie(s.field, s.range, s.explosion); };
  if (!scene_ || told(wanted) != told(scene_->settings())) card_->hide();  // it tells a value, at a place
  const double before = scene_ ? scene_->settings().explosion : wanted.explosion;
  if (before == 0 && wanted.explosion > 0) together_ = Standing{scene_->pose(), scene_->fits_itself()};
  applySettings();
  if (wanted.explosion == before) return;
  if (wanted.explosion == 0 && together_) {
    takeStanding(*together_);
    render();
  } else {
    fit();
  }
}

bool Viewport::showsField() const {
  return session_.playback.frame() && !showsSolids_ && !isSetUp(session_.display.page());
}

SceneSettings Viewport::screenSettings() const {
  SceneSettings settings = session_.display.settings();
  settings.smooth_outlines = false;
  if (showsJoints()) settings.rock_opacity = rock_with_joints;
  settings.text_height = theme::now().type.small * devicePixelRatioF();
  if (!session_.compared.runs().empty()) settings.title = session_.compared.nameOfOpen().toStdString();
  return settings;
}

void Viewport::applySettings() {
  if (!scene_) return;
  SceneSettings settings = screenSettings();
  settings.fine = still_ && drag_ == Drag::none && !isComputing();
  settings.parallel_projection = scene_->settings().parallel_projection;
  if (!showsField()) settings.field.reset();
  if (session_.display.page() != WorkflowPage::results) settings.probed_line.reset();
  if (const auto* surfaces = session_.surfaces.current(); surfaces && showsSolids_)
    for (const SolidSurface& surface : *surfaces)
      std::ranges::copy(oddPlaces(surface), std::back_inserter(settings.places));
  scene_->set_settings(settings);
  render();
}

void Viewport::applySelection() {
  if (!scene_) return;
  const std::vector<int> chosen = selectedInView();
  scene_->set_selected(chosen);
  if (chosen.empty()) card_->hide();
  render();
}

bool Viewport::showsJoints() const {
  return session_.display.page() == WorkflowPage::joints && session_.display.settings().joints;
}

void Viewport::applyJoints() {
  if (!scene_) return;
  const bool isOther = showsJoints() ? scene_->set_joints(session_.joints.faces(), session_.joints.selectedCuts())
                                     : scene_->set_joints(nullptr, {});
  if (isOther) render();
}

Selection& Viewport::selection() const { return session_.project.selection(); }

bool Viewport::isRunning() const { return session_.run.isBusy(); }

/// A run that pauses does not.
bool Viewport::isComputing() const {
  const JobState state = session_.run.job().state();
  return state == JobState::running || state == JobState::meshing || state == JobState::stopping;
}

const SceneSettings& Viewport::displayed() const { return session_.display.settings(); }

Display& Viewport::display() const { return session_.display; }

Playback& Viewport::playback() const { return session_.playback; }

const Project& Viewport::project() const { return session_.project.document().project(); }

WorkflowPage Viewport::page() const { return session_.display.page(); }

void Viewport::applyTroubles() {
  if (!scene_) return;
  scene_->set_troubles(session_.run.troubles());
  render();
}

/// And blocks of other results.
void Viewport::applyTrails() {
  if (!scene_) return;
  scene_->set_trails(session_.trails.trails());
  scene_->set_ghost(showsSolids_ ? Ghost{} : ghost_);
  render();
}

void Viewport::flyTo(const CameraPose& pose) {
  flight_.stop();
  flightStart_ = scene_->pose();
  flightEnd_ = pose;
  flight_.start();
}

void Viewport::render() {
  if (!scene_) return;
  if (!isComputing() || drag_ != Drag::none) {
    drawNow();
    return;
  }
  // While the solver works the window must stay free for the hand.
  if (drawTimer_.isActive()) return;
  const double pause = std::max<double>(live_pause_ms, surface_->lastSeconds() * 1000 / live_share);
  const double since = sinceDrawing_.isValid() ? static_cast<double>(sinceDrawing_.elapsed()) : pause;
  drawTimer_.start(static_cast<int>(std::max(0.0, pause - since)));
}

void Viewport::drawNow() {
  sinceDrawing_.start();
  surface_->requestRender();
  told_ = pose();
  emit redrawn();
}

/// Of another size the view is fitted anew, which is known when it has been drawn.
void Viewport::tellOfFit() {
  if (!scene_) return;
  const CameraPose now = scene_->pose();
  if (told_ && now.position == told_->position && now.parallel_scale == told_->parallel_scale) return;
  told_ = now;
  QMetaObject::invokeMethod(this, &Viewport::redrawn, Qt::QueuedConnection);
}

void Viewport::moveTo(const CameraPose& pose) {
  if (scene_) moveCamera(pose);
}

void Viewport::becomeStill() {
  still_ = true;
  applySettings();
}

void Viewport::moveCamera(const CameraPose& pose) {
  scene_->set_pose(pose);
  card_->hide();
  if (still_) {
    still_ = false;
    applySettings();
  }
  stillTimer_.start();
  drawNow();
}

void Viewport::takeStanding(const Standing& standing) {
  standing.fits ? scene_->take_fit(standing.pose) : scene_->set_pose(standing.pose);
}

void Viewport::look(View view) {
  if (!scene_) return;
  scene_->look(view);
  render();
}

void Viewport::fit() {
  if (!scene_) return;
  scene_->fit();
  card_->hide();
  render();
}

void Viewport::toggleProjection() {
  if (!scene_) return;
  moveCamera(withOtherProjection(scene_->pose()));
}

void Viewport::toggleExplosion() {
  if (!scene_) return;
  SceneSettings settings = session_.display.settings();
  settings.explosion = settings.explosion == 0 ? apart : 0;
  session_.display.set(settings);
}

std::optional<CameraPose> Viewport::pose() const {
  return scene_ ? std::optional<CameraPose>(scene_->pose()) : std::nullopt;
}

std::optional<PixelRect> Viewport::rockArea() const {
  return scene_ ? std::optional<PixelRect>(scene_->rock_area()) : std::nullopt;
}

bool Viewport::hasRock() const { return !project().solids.empty(); }

void Viewport::showEmptyState() {
  const JobState state = session_.run.job().state();
  const bool isCutting = state == JobState::meshing || (state == JobState::stopping && !session_.playback.isLive());
  const bool isShown = !system_ || (showsSolids_ && isCutting);
  empty_->setVisible(isShown);
  if (!isShown) return;
  if (isCutting) {
    const int percent = static_cast<int>(100 * session_.run.fraction());
    QStringList lines{tr("Cutting and meshing, %1 %").arg(percent), session_.run.activity()};
    const auto left = session_.run.job().timeLeft().seconds();
    if (left && *left > told_seconds) lines << tr("%1 left").arg(numbers::duration(*left));
    emptyText_->setText(lines.join(u'\n'));
    emptyButton_->setText(tr("Cancel"));
    emptyButton_->setEnabled(state == JobState::meshing);
    emptyButton_->setToolTip(tr("The blocks stay as they were before; it can be begun again"));
  } else {
    emptyButton_->setText(hasRock() ? tr("Cut and mesh") : tr("Import geometry…"));
    emptyText_->setText(session_.surfaces.isBusy() ? tr("Reading the solids …")
                        : hasRock()
                            ? tr("There are no blocks yet: cut the rock along its joints and mesh it to see them.")
                            : tr("There is no rock yet: import geometry, or make a new solid."));
    const QString whyNot = hasRock() ? session_.whyNotMesh() : QString();
    emptyButton_->setEnabled(whyNot.isEmpty());
    emptyButton_->setToolTip(!whyNot.isEmpty() ? whyNot
                             : hasRock()       ? tr("Divides the rock along its cuts into blocks and meshes each (F4)")
                                               : tr("Solids and terrain from a file, shown before they are taken"));
  }
  placeOverlays();
}

void Viewport::resizeEvent(QResizeEvent*) {
  overlay_->setGeometry(rect());
  placeOverlays();
  surface_->widget()->setGeometry(rect());  // last: where a card draws, it does so at once, and rock keeps beside tools
}

void Viewport::placeOverlays() {
  constexpr int away = 12;
  tools_->adjustSize();
  tools_->move(width() - tools_->width() - away, away);
  tools_->setVisible(system_ && tools_->height() + 2 * away <= height());  // menus and keys have them too
  tools_->raise();
  keepLabelsBesideTools();
  picker_->adjustSize();
  picker_->move((tools_->x() - picker_->width()) / 2, 12);
  picker_->raise();
  empty_->adjustSize();
  empty_->setGeometry(0, (height() - empty_->height()) / 2, width(), empty_->height());
}

}  // namespace talus
