#include "widgets/window/main_window.hpp"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QScreen>
#include <QSettings>
#include <QShortcut>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>

#include "base/error.hpp"
#include "jobs/solver_job.hpp"
#include "widgets/begin/start_page.hpp"
#include "widgets/geometry/solid_tools.hpp"
#include "widgets/joints/joint_handles.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/typing_keys.hpp"
#include "widgets/project/problem_count.hpp"
#include "widgets/project/problem_list.hpp"
#include "widgets/project/project_tree.hpp"
#include "widgets/results/display_panel.hpp"
#include "widgets/results/export_strip.hpp"
#include "widgets/run/run_panel.hpp"
#include "widgets/setup/property_panel.hpp"
#include "widgets/view/compared_viewport.hpp"
#include "widgets/view/timeline.hpp"
#include "widgets/view/viewport.hpp"
#include "widgets/window/bottom_panel.hpp"
#include "widgets/window/command_search.hpp"
#include "widgets/window/guards.hpp"
#include "widgets/window/rail.hpp"
#include "widgets/window/top_bar.hpp"
#include "widgets/window/units_button.hpp"
#include "widgets/window/window_actions.hpp"
#include "widgets/window/workflow_bar.hpp"

namespace talus {

namespace {

constexpr int tree_width = 232, right_width = 292, bottom_height = 204;
const QSize smallest(1024, 640);

QToolBar* makeBar(QMainWindow* window, QWidget* content) {
  auto* bar = new QToolBar(window);
  bar->setMovable(false);
  bar->setFloatable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  bar->layout()->setContentsMargins(0, 0, 0, 0);
  bar->addWidget(content);
  return bar;
}

}  // namespace

MainWindow::MainWindow(SolverParts parts)
    : session_(std::move(parts)),
      autosave_(session_.project.document()),
      guards_(new Guards(session_, *this, [this] { return saveAs(); })) {
  session_.display.setDark(theme::now().dark);
  // First of all who listen: they paint with the new colours.
  connect(&session_.display, &Display::themeChanged, this, [this] { theme::install(session_.display.isDark()); });
  setMinimumSize(smallest);
  qApp->installEventFilter(new TypingKeys(this));
  actions_ = new WindowActions(session_, *this);
  // From the outside inwards: whatever is put into another part is styled anew, with all that is in it.
  makeBars();
  makeCentre();
  makeDocks();
  makeStatusBar();
  makeViewTools();
  new JointHandles(session_, *viewport_);
  actions_->drive(*viewport_, *timeline_);
  actions_->solids->measureIn(*viewport_);
  connectActions();
  connect(&session_.display, &Display::pageChanged, this, &MainWindow::showPage);
  connect(
      &session_.display, &Display::fieldWanted, this, [this](const QString& place) { focusField(place); },
      Qt::QueuedConnection);  // the panel of the thing is made first
  connect(&session_.project, &CurrentProject::opened, this, [this] { showStart(false); });
  connect(&session_.project, &CurrentProject::opened, this, &MainWindow::updateTitle);
  connect(&session_.project.document(), &Document::savedChanged, this, &MainWindow::updateTitle);
  connect(&autosave_, &Autosave::failed, this,
          [this](const InputError& error) { session_.messages.add(problemOf(error, Problem::Severity::warning)); });
  setAcceptDrops(true);
  showStart(true);
  showPage();
  updateTitle();
}

// What is hidden tells the session so: while there is one.
MainWindow::~MainWindow() { hide(); }

void MainWindow::makeBars() {
  topBar_ = new TopBar(session_.project.document(), session_.display, *actions_);
  workflowBar_ = new WorkflowBar(session_, *actions_);
  rail_ = new Rail(session_);
  addToolBar(Qt::TopToolBarArea, makeBar(this, topBar_));
  addToolBarBreak(Qt::TopToolBarArea);
  bars_ = {makeBar(this, workflowBar_), makeBar(this, rail_)};
  addToolBar(Qt::TopToolBarArea, bars_[0]);
  addToolBar(Qt::LeftToolBarArea, bars_[1]);
  auto* search = new QShortcut(QKeySequence(tr("Ctrl+K")), this);
  connect(search, &QShortcut::activated, &topBar_->search(), &CommandSearch::begin);
}

void MainWindow::makeCentre() {
  auto* whole = new QWidget(this);
  centre_ = new QStackedWidget(whole);
  start_ = new StartPage;
  auto* work = new QWidget(centre_);
  auto* column = new QVBoxLayout(work);
  setMargins(column, 0, 0);
  viewport_ = new Viewport(session_);
  timeline_ = new Timeline(session_.project.document(), session_.run, session_.playback);
  views_ = new ComparedViewports(session_.compared, *viewport_);
  column->addWidget(views_, 1);
  column->addWidget(timeline_);
  centre_->addWidget(start_);
  centre_->addWidget(work);
  auto* withStrip = new QVBoxLayout(whole);
  setMargins(withStrip, 0, 0);
  withStrip->addWidget(new ProblemStrip(session_.messages, session_.display));
  withStrip->addWidget(centre_, 1);
  setCentralWidget(whole);
  connect(start_, &StartPage::openRequested, this, &MainWindow::askForProject);
  connect(start_, &StartPage::openResultsRequested, this, &MainWindow::askForResults);
  connect(start_, &StartPage::fileChosen, this, &MainWindow::open);
  connect(start_, &StartPage::sampleChosen, this, &MainWindow::openCopy);
  connect(start_, &StartPage::templateChosen, this, [this](const QString& key) { newProject(key.toStdString()); });
  connect(start_, &StartPage::returnRequested, this, [this] { showStart(false); });
}

QDockWidget* MainWindow::makeDock(const QString& name) {
  auto* dock = new QDockWidget(name, this);
  dock->setObjectName(name);
  dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
  dock->setTitleBarWidget(new QWidget);  // each panel brings its own header
  return dock;
}

/// Only a dock that has its content already is as wide as that wants.
void MainWindow::addDock(Qt::DockWidgetArea area, QDockWidget* dock, QWidget* content) {
  dock->setWidget(content);
  addDockWidget(area, dock);
}

void MainWindow::makeDocks() {
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  left_ = makeDock(QStringLiteral("project"));
  auto* project = makePlane("surface");
  project->setParent(left_);
  auto* column = new QVBoxLayout(project);
  setMargins(column, 0, 0);
  column->addWidget(new PanelHeader(tr("Project")));
  tree_ = new ProjectTree(session_.project, session_.display, session_.messages);
  auto* newSolid = new QMenu(this);
  newSolid->setToolTipsVisible(true);
  actions_->solids->addNew(*newSolid);
  tree_->setNewMenu(WorkflowPage::geometry, newSolid);
  column->addWidget(tree_, 1);
  project->setMinimumWidth(tree_width);
  addDock(Qt::LeftDockWidgetArea, left_, project);
  right_ = makeDock(QStringLiteral("properties"));
  auto* right = makePlane("surface");
  right->setParent(right_);
  rightPages_ = new QStackedWidget(right);
  rightPages_->addWidget(new PropertyPanel(session_.project, session_.survey, session_.playback, session_.messages,
                                           session_.display, session_.picking));
  rightPages_->addWidget(new RunPanel(session_.project, session_.run, session_.study, session_.display));
  rightPages_->addWidget(new DisplayPanel(session_.display, session_.run));
  auto* rightColumn = new QVBoxLayout(right);
  setMargins(rightColumn, 0, 0);
  rightColumn->addWidget(rightPages_);
  right->setMinimumWidth(right_width);
  addDock(Qt::RightDockWidgetArea, right_, right);
  bottom_ = makeDock(QStringLiteral("bottom"));
  addDock(Qt::BottomDockWidgetArea, bottom_, new BottomPanel(session_, *actions_));
}

void MainWindow::makeStatusBar() {
  auto* bar = statusBar();
  bar->setSizeGripEnabled(false);
  bar->setContentsMargins(8, 0, 8, 0);
  message_ = new ElidedLabel({}, "small");
  bar->addWidget(message_, 1);
  bar->addPermanentWidget(new ExportStrip(exporter_));
  auto* count = new ProblemCount(session_.project, session_.messages);
  connect(count, &QToolButton::clicked, this, [this] { static_cast<BottomPanel*>(bottom_->widget())->showProblems(); });
  bar->addPermanentWidget(count);
  auto* pointed = makeLabel({}, "small");
  pointed->setObjectName(QStringLiteral("pointed"));
  pointed->setToolTip(tr("Under the mouse: east, north and height in the coordinates of the survey"));
  bar->addPermanentWidget(pointed);
  connect(viewport_, &Viewport::pointedAt, pointed, &QLabel::setText);
  place_ = makeLabel({}, "small");
  bar->addPermanentWidget(place_);
  bar->addPermanentWidget(new UnitsButton(session_.display));
  connect(&session_.messages, &Messages::logged, message_, &QLabel::setText);
  connect(&session_.playback, &Playback::frameChanged, this, [this] {
    const auto frames = session_.playback.times().size();
    place_->setText(frames == 0 ? QString() : tr("Frame %1 of %2").arg(session_.playback.number() + 1).arg(frames));
  });
  connect(&exporter_, &ExportJob::busyChanged, &session_.playback, &Playback::setExporting);
  connect(&exporter_, &ExportJob::finished, this,
          [this](const QString& path) { session_.messages.log(tr("wrote %1").arg(path)); });
  connect(&exporter_, &ExportJob::cancelledByUser, this,
          [this] { session_.messages.log(tr("cancelled; no file was left")); });
  connect(&exporter_, &ExportJob::failed, this,
          [this](const InputError& error) { session_.messages.add(problemOf(error, Problem::Of::picture)); });
}

void MainWindow::makeViewTools() {
  auto* column = static_cast<QVBoxLayout*>(viewport_->tools()->layout());
  for (auto* action : {actions_->fit, actions_->iso, actions_->projection, actions_->isolate, actions_->hide,
                       actions_->showJoints, actions_->showActions, actions_->savePicture})
    column->addWidget(makeActionButton(action, false));
}

void MainWindow::showStart(bool start) {
  if (start) {
    keepPictureOfProject();
    start_->refresh(session_.project.document().isOpen());
  }
  centre_->setCurrentIndex(start ? 0 : 1);
  for (auto* bar : bars_) bar->setVisible(!start);
  for (auto* dock : {left_, right_, bottom_}) dock->setVisible(!start);
  if (!start && !docksSized_) {
    docksSized_ = true;
    resizeDocks({bottom_}, {bottom_height}, Qt::Vertical);  // docks take sizes only once they are to be seen
  }
  centre_->currentWidget()->setFocus();  // or the first tool button would take it
}

void MainWindow::showPage() {
  const WorkflowPage page = session_.display.page();
  rightPages_->setCurrentIndex(isSetUp(page) ? 0 : page == WorkflowPage::solve ? 1 : 2);
  timeline_->setVisible(!isSetUp(page));
  SceneSettings settings = session_.display.settings();
  settings.edges = page == WorkflowPage::mesh ? Edges::mesh : Edges::blocks;
  if (settings.edges != session_.display.settings().edges) session_.display.set(settings);
}

/// Fields are named after their place in the project file; where one has none, the thing that it belongs to has.
/// A list that lacks a thing has the button that makes one.
void MainWindow::focusField(QString place) {
  if (place.count(u'/') == 1 && left_->findChild<ProjectTree*>()->focusNew(place.mid(1))) return;
  for (; !place.isEmpty(); place.truncate(place.lastIndexOf(u'/'))) {
    auto* field = right_->findChild<QWidget*>(place);
    if (!field) continue;
    field->setFocus(Qt::ShortcutFocusReason);
    return;
  }
  for (auto* first : right_->findChildren<NumberField*>())
    if (first->isVisible()) return first->setFocus(Qt::ShortcutFocusReason);
  rightPages_->setFocus(Qt::ShortcutFocusReason);
}

void MainWindow::showViewAlone(bool alone) {
  if (centre_->currentIndex() == 0) return;
  for (auto* bar : bars_) bar->setVisible(!alone);
  for (auto* dock : {left_, right_, bottom_}) dock->setVisible(!alone);
}

void MainWindow::updateTitle() {
  const Document& document = session_.project.document();
  setWindowTitle(document.isOpen()
                     ? tr("%1%2 - Talus").arg(document.name(), document.isSaved() ? QString() : QStringLiteral("*"))
                     : QStringLiteral("Talus"));
}

void MainWindow::present(std::optional<QSize> wanted) {
  if (wanted)
    resize(*wanted);
  else if (!restoreGeometry(QSettings().value(QStringLiteral("geometry")).toByteArray()))
    resize(size().boundedTo(screen()->availableSize()));
  show();
  QTimer::singleShot(0, viewport_, &Viewport::warmUp);
}

ExportTask MainWindow::exportTask(const std::filesystem::path& path, int width) {
  ExportTask task;
  task.system = viewport_->shown();
  task.settings = viewport_->screenSettings();
  if (!viewport_->showsField()) task.settings.field.reset();
  task.settings.parallel_projection = viewport_->pose()->parallel;
  task.pose = *viewport_->pose();
  task.hidden = viewport_->hiddenBlocks();
  task.troubles = session_.run.troubles();
  task.selected = session_.project.selection().blocks();
  task.trails = session_.trails.trails();
  task.actions = viewport_->actions();
  if (viewport_->showsJoints()) {
    task.joints = session_.joints.faces();
    task.chosenCuts = session_.joints.selectedCuts();
  }
  task.stageNames = session_.run.stageNames();
  task.path = path;
  task.film.width = width;
  task.film.height = heightFor(width, *viewport_);
  return task;
}

/// Of a picture of this width in a view's shape; films want even sizes.
int MainWindow::heightFor(int width, const QWidget& view) {
  return width * view.height() / std::max(1, view.width()) / 2 * 2;
}

void MainWindow::savePicture(const std::filesystem::path& path, int width) {
  if (!viewport_->shown()) return;
  ExportTask task = exportTask(path, width);
  if (const auto frame = session_.playback.frame(); frame && !viewport_->showsSolids()) {
    task.frame = [frame](int) { return frame; };
    task.times = {frame->time};
    task.ghost = viewport_->ghost();
    for (const auto& run : session_.compared.runs())
      if (const auto beside = run->frame())
        task.compared.push_back({run->results()->system,
                                 {beside->time},
                                 [beside](int) { return beside; },
                                 session_.compared.nameOf(*run).toStdString(),
                                 run->results()->stage_names});
    if (!task.compared.empty()) task.film.height = heightFor(task.film.width, *views_);
  }
  task.what = tr("Picture");
  session_.messages.settle(Problem::Of::picture);
  exporter_.start(std::move(task));
}

void MainWindow::saveFilm(const std::filesystem::path& path, const FilmOptions& film) {
  if (session_.playback.times().empty()) return;
  ExportTask task = exportTask(path, film.width);
  task.film.fps = film.fps;
  task.film.camera = film.camera;
  task.film.from = film.from;
  task.film.to = film.to;
  task.settings.field = session_.display.settings().field;
  if (viewport_->showsSolids()) {  // a film is of the blocks
    task.system = session_.project.system();
    task.settings.rock_opacity = session_.display.settings().rock_opacity;
    task.joints.reset();
    task.hidden.clear();
  }
  task.frame = session_.playback.source();
  task.times = session_.playback.times();
  task.film.speed = timeline_->speed();
  task.film.over = film.over;
  for (const auto& run : session_.compared.runs()) {
    const ResultsIndex& results = *run->results();
    if (results.frame_times.empty() || (film.over && !task.compared.empty())) continue;
    task.compared.push_back({results.system, results.frame_times, framesOf(results.folder),
                             session_.compared.nameOf(*run).toStdString(), results.stage_names});
  }
  if (task.compared.empty() || film.over)
    task.settings.title = session_.project.document().name().toStdString();
  else
    task.film.height = heightFor(film.width, *views_);
  task.what = tr("Film");
  session_.messages.settle(Problem::Of::picture);
  exporter_.start(std::move(task));
}

void MainWindow::saveReport(const std::filesystem::path& path) {
  write(tr("Report"), path, writingOfReport(session_.playback.folder(), path));
}

void MainWindow::exportData(DataFormat format, const std::filesystem::path& path) {
  write(tr("Export"), path,
        writingOfData(format, session_.playback.folder(), std::max(0, session_.playback.number()), path));
}

void MainWindow::write(const QString& what, const std::filesystem::path& path, Writing writing) {
  if (session_.playback.folder().empty() || session_.playback.isLive()) return;
  session_.messages.settle(Problem::Of::picture);
  exporter_.start(what, path, std::move(writing));
}

/// False also where it is closed later: the step that is being made ends first, and the window stays alive meanwhile.
bool MainWindow::mayCloseDuringRun() {
  constexpr auto later = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
  const Guards::OfRun answer = guards_->askOfRun();
  if (!session_.run.isBusy()) return true;
  if (answer == Guards::OfRun::stay) return false;
  closing_ = true;
  if (answer == Guards::OfRun::leave) {
    session_.messages.log(tr("the window closes as soon as the run goes on in the background"));
    connect(&session_.run, &CurrentRun::left, this, &QWidget::close, later);
    session_.run.leave();
  } else {
    session_.messages.log(tr("stopping the run before the window closes"));
    connect(&session_.run.job(), &SolverJob::ended, this, &QWidget::close, later);
    session_.run.stop();
  }
  return false;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->ignore();
  if (session_.run.isBusy() && (closing_ || !mayCloseDuringRun())) return;
  closing_ = false;
  if (!guards_->mayLeaveProject()) return;
  keepPictureOfProject();
  QSettings().setValue(QStringLiteral("geometry"), saveGeometry());
  event->accept();
}

}  // namespace talus
