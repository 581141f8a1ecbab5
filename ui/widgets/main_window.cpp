#include "widgets/main_window.hpp"

#include <QCloseEvent>
#include <QSettings>
#include <QShortcut>
#include <QStatusBar>
#include <QToolBar>

#include "widgets/bottom_panel.hpp"
#include "widgets/display_panel.hpp"
#include "widgets/export_strip.hpp"
#include "widgets/numbers.hpp"
#include "widgets/parts.hpp"
#include "widgets/problem_list.hpp"
#include "widgets/project_tree.hpp"
#include "widgets/property_panel.hpp"
#include "widgets/rail.hpp"
#include "widgets/run_panel.hpp"
#include "widgets/samples.hpp"
#include "widgets/start_page.hpp"
#include "widgets/step_bar.hpp"
#include "widgets/timeline.hpp"
#include "widgets/top_bar.hpp"
#include "widgets/viewport.hpp"
#include "widgets/window_actions.hpp"

namespace talus {

namespace {

constexpr int tree_width = 232, right_width = 292, bottom_height = 204;
const QSize smallest(1024, 640);

QToolBar* makeBar(QWidget* content) {
  auto* bar = new QToolBar;
  bar->setMovable(false);
  bar->setFloatable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  bar->layout()->setContentsMargins(0, 0, 0, 0);
  bar->addWidget(content);
  return bar;
}

}  // namespace

MainWindow::MainWindow(SolverSteps steps) : workspace_(std::move(steps)) {
  workspace_.setDark(theme::now().dark);
  setMinimumSize(smallest);
  actions_ = new WindowActions(workspace_, *this);
  makeBars();
  makeCentre();
  makeDocks();
  makeStatusBar();
  makeViewTools();
  actions_->drive(*viewport_, *timeline_);
  connectActions();
  connect(&workspace_, &Workspace::stepChanged, this, &MainWindow::showStep);
  connect(&workspace_, &Workspace::projectOpened, this, [this] { showStart(false); });
  connect(&workspace_, &Workspace::projectOpened, this, &MainWindow::updateTitle);
  connect(&workspace_.document(), &Document::savedChanged, this, &MainWindow::updateTitle);
  showStart(true);
  showStep();
  updateTitle();
}

MainWindow::~MainWindow() = default;

void MainWindow::makeBars() {
  topBar_ = new TopBar(workspace_, *actions_);
  stepBar_ = new StepBar(workspace_, *actions_);
  rail_ = new Rail(workspace_);
  addToolBar(Qt::TopToolBarArea, makeBar(topBar_));
  addToolBarBreak(Qt::TopToolBarArea);
  bars_ = {makeBar(stepBar_), makeBar(rail_)};
  addToolBar(Qt::TopToolBarArea, bars_[0]);
  addToolBar(Qt::LeftToolBarArea, bars_[1]);
  auto* search = new QShortcut(QKeySequence(tr("Ctrl+K")), this);
  connect(search, &QShortcut::activated, topBar_, &TopBar::focusSearch);
}

void MainWindow::makeCentre() {
  centre_ = new QStackedWidget;
  start_ = new StartPage;
  auto* work = new QWidget;
  auto* column = new QVBoxLayout(work);
  setMargins(column, 0, 0);
  viewport_ = new Viewport(workspace_);
  timeline_ = new Timeline(workspace_);
  column->addWidget(viewport_, 1);
  column->addWidget(timeline_);
  centre_->addWidget(start_);
  centre_->addWidget(work);
  auto* whole = new QWidget;
  auto* withStrip = new QVBoxLayout(whole);
  setMargins(withStrip, 0, 0);
  withStrip->addWidget(new ProblemStrip(workspace_));
  withStrip->addWidget(centre_, 1);
  setCentralWidget(whole);
  connect(start_, &StartPage::openRequested, this, &MainWindow::askForProject);
  connect(start_, &StartPage::openResultsRequested, this, &MainWindow::askForResults);
  connect(start_, &StartPage::fileChosen, this, &MainWindow::open);
}

QDockWidget* MainWindow::addDock(Qt::DockWidgetArea area, const QString& name, QWidget* content) {
  auto* dock = new QDockWidget(name);
  dock->setObjectName(name);
  dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
  dock->setTitleBarWidget(new QWidget);  // each panel brings its own header
  dock->setWidget(content);
  addDockWidget(area, dock);
  return dock;
}

void MainWindow::makeDocks() {
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  auto* project = makePlane("surface");
  auto* column = new QVBoxLayout(project);
  setMargins(column, 0, 0);
  column->addWidget(new PanelHeader(tr("Project")));
  column->addWidget(new ProjectTree(workspace_), 1);
  project->setMinimumWidth(tree_width);
  left_ = addDock(Qt::LeftDockWidgetArea, QStringLiteral("project"), project);
  rightPages_ = new QStackedWidget;
  rightPages_->addWidget(new PropertyPanel(workspace_));
  rightPages_->addWidget(new RunPanel(workspace_));
  rightPages_->addWidget(new DisplayPanel(workspace_));
  auto* right = makePlane("surface");
  auto* rightColumn = new QVBoxLayout(right);
  setMargins(rightColumn, 0, 0);
  rightColumn->addWidget(rightPages_);
  right->setMinimumWidth(right_width);
  right_ = addDock(Qt::RightDockWidgetArea, QStringLiteral("properties"), right);
  bottom_ = addDock(Qt::BottomDockWidgetArea, QStringLiteral("bottom"), new BottomPanel(workspace_));
}

void MainWindow::makeStatusBar() {
  auto* bar = statusBar();
  bar->setSizeGripEnabled(false);
  bar->setContentsMargins(8, 0, 8, 0);
  message_ = new ElidedLabel({}, "small");
  bar->addWidget(message_, 1);
  auto* strip = new ExportStrip(exporter_);
  strip->setObjectName(QStringLiteral("export"));
  bar->addPermanentWidget(strip);
  place_ = makeLabel({}, "small");
  bar->addPermanentWidget(place_);
  bar->addPermanentWidget(makeLabel(QStringLiteral("  m · kN · MPa · °  "), "small"));
  connect(&workspace_, &Workspace::logged, message_, &QLabel::setText);
  connect(&workspace_, &Workspace::frameChanged, this, [this] {
    const auto frames = workspace_.frameTimes().size();
    place_->setText(frames == 0 ? QString() : tr("Frame %1 of %2").arg(workspace_.frameNumber() + 1).arg(frames));
  });
  connect(&exporter_, &ExportJob::busyChanged, &workspace_, &Workspace::setExporting);
  connect(&exporter_, &ExportJob::finished, this,
          [this](const QString& path) { workspace_.log(tr("wrote %1").arg(path)); });
  connect(&exporter_, &ExportJob::cancelledByUser, this, [this] { workspace_.log(tr("cancelled; no file was left")); });
  connect(&exporter_, &ExportJob::failed, this, [this](const QString& place, const QString& what, const QString& cure) {
    workspace_.addProblem({Problem::Severity::error, place, what, cure});
  });
}

void MainWindow::makeViewTools() {
  auto* column = static_cast<QVBoxLayout*>(viewport_->tools()->layout());
  for (auto* action :
       {actions_->fit, actions_->iso, actions_->projection, actions_->isolate, actions_->hide, actions_->savePicture})
    column->addWidget(makeActionButton(action, false));
}

void MainWindow::showStart(bool start) {
  if (start) start_->refresh();
  centre_->setCurrentIndex(start ? 0 : 1);
  for (auto* bar : bars_) bar->setVisible(!start);
  for (auto* dock : {left_, right_, bottom_}) dock->setVisible(!start);
  if (!start && !docksSized_) {
    docksSized_ = true;
    resizeDocks({bottom_}, {bottom_height}, Qt::Vertical);  // docks take sizes only once they are to be seen
  }
  centre_->currentWidget()->setFocus();  // or the first tool button would take it
}

void MainWindow::showStep() {
  const Step step = workspace_.step();
  rightPages_->setCurrentIndex(isSetUp(step) ? 0 : step == Step::solve ? 1 : 2);
  timeline_->setVisible(!isSetUp(step));
  SceneSettings display = workspace_.display();
  display.edges = step == Step::mesh ? Edges::mesh : Edges::blocks;
  if (display.edges != workspace_.display().edges) workspace_.setDisplay(display);
}

void MainWindow::showViewAlone(bool alone) {
  if (centre_->currentIndex() == 0) return;
  for (auto* bar : bars_) bar->setVisible(!alone);
  for (auto* dock : {left_, right_, bottom_}) dock->setVisible(!alone);
}

void MainWindow::updateTitle() {
  const Document& document = workspace_.document();
  setWindowTitle(document.isOpen()
                     ? tr("%1%2 - Talus").arg(document.name(), document.isSaved() ? QString() : QStringLiteral("*"))
                     : QStringLiteral("Talus"));
}

void MainWindow::open(const std::filesystem::path& path) {
  if (workspace_.document().isOpen() && !askToSave()) return;
  if (workspace_.open(path)) rememberRecent(path);
}

ExportTask MainWindow::exportTask(const std::filesystem::path& path, int width) const {
  ExportTask task;
  task.system = workspace_.system();
  task.settings = workspace_.display();
  if (!workspace_.frame()) task.settings.field.reset();
  task.settings.parallel_projection = viewport_->pose()->parallel;
  task.pose = *viewport_->pose();
  task.hidden = viewport_->hiddenBlocks();
  task.struggles = workspace_.struggles();
  task.stageNames = workspace_.stageNames();
  task.path = path;
  task.film.width = width;
  task.film.height = width * viewport_->height() / std::max(1, viewport_->width()) / 2 * 2;  // films want even sizes
  return task;
}

void MainWindow::savePicture(const std::filesystem::path& path) {
  if (!workspace_.system() || exporter_.isBusy()) return;
  ExportTask task = exportTask(path, 1920);
  if (const auto frame = workspace_.frame()) {
    task.frame = [frame](int) { return frame; };
    task.frameCount = 1;
  }
  findChild<ExportStrip*>(QStringLiteral("export"))->begin(tr("Picture"));
  exporter_.start(std::move(task));
}

void MainWindow::saveFilm(const std::filesystem::path& path) {
  if (workspace_.frameTimes().empty() || exporter_.isBusy()) return;
  ExportTask task = exportTask(path, 1280);
  task.frame = workspace_.frameSource();
  task.frameCount = static_cast<int>(workspace_.frameTimes().size());
  findChild<ExportStrip*>(QStringLiteral("export"))->begin(tr("Film"));
  exporter_.start(std::move(task));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (workspace_.job().isBusy()) {
    // The step that is being made ends first; the window stays alive meanwhile.
    event->ignore();
    if (closing_) return;
    closing_ = true;
    workspace_.log(tr("stopping the run before the window closes"));
    connect(&workspace_.job(), &SolverJob::ended, this, &QWidget::close, Qt::QueuedConnection);
    workspace_.job().stop();
    return;
  }
  closing_ = false;
  if (!askToSave()) {
    event->ignore();
    return;
  }
  QSettings().setValue(QStringLiteral("geometry"), saveGeometry());
  event->accept();
}

}  // namespace talus
