#include "widgets/window/window_actions.hpp"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QWidget>

#include "jobs/solver_job.hpp"
#include "session/session.hpp"
#include "widgets/actions/load_actions.hpp"
#include "widgets/blocks/block_actions.hpp"
#include "widgets/geometry/solid_tools.hpp"
#include "widgets/joints/joint_actions.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/view/timeline.hpp"
#include "widgets/view/viewport.hpp"
#include "widgets/window/language_menu.hpp"

namespace talus {

namespace {

/// What goes to a page is called as the page; where another command has that name already it says more.
QString pageCommand(WorkflowPage page) {
  return page == WorkflowPage::solve ? QObject::tr("Solve page") : pageTitle(page);
}

}  // namespace

WindowActions::WindowActions(Session& session, QWidget& window) : QObject(&window), session_(session), window_(window) {
  makeFileActions();
  makeViewActions();
  makeRunActions();
  solids = new SolidTools(session_, window_);
  for (auto* action : solids->all()) include(action);
  joints = new JointActions(session_, window_);
  for (auto* action : joints->all()) include(action);
  loads = new LoadActions(session_, window_);
  for (auto* action : loads->all()) include(action);
  blocks = new BlockActions(session_, window_);
  for (auto* action : blocks->all()) include(action);
  connect(&session_.project, &CurrentProject::opened, this, &WindowActions::refresh);
  connect(&session_.project, &CurrentProject::systemChanged, this, &WindowActions::refresh);
  connect(&session_.surfaces, &SolidSurfaces::changed, this, &WindowActions::refresh);
  connect(&session_.playback, &Playback::framesChanged, this, &WindowActions::refresh);
  connect(&session_.run.job(), &SolverJob::stateChanged, this, &WindowActions::refresh);
  connect(&session_.run, &CurrentRun::checkpointChanged, this, &WindowActions::refresh);
  connect(&session_.run, &CurrentRun::outsideChanged, this, &WindowActions::refresh);
  connect(&session_.project.document(), &Document::savedChanged, this, &WindowActions::refresh);
  connect(&session_.project.document(), &Document::projectChanged, this, &WindowActions::refresh);
  connect(&session_.project.selection(), &Selection::changed, this, &WindowActions::refresh);
  connect(&session_.project.problems(), &ProjectProblems::changed, this, &WindowActions::refresh);
  connect(&session_.survey, &BlockSurvey::changed, this, &WindowActions::refresh);
  refresh();
}

QAction* WindowActions::add(const QString& text, const QString& icon, const QKeySequence& shortcut) {
  auto* action = new QAction(text, this);
  if (!icon.isEmpty()) action->setIcon(theme::icon(icon));
  action->setShortcut(shortcut);
  include(action);
  return action;
}

void WindowActions::include(QAction* action) {
  action->setShortcutContext(Qt::WindowShortcut);
  window_.addAction(action);
  all_.push_back(action);
}

void WindowActions::makeFileActions() {
  newProject = add(tr("New…"), QStringLiteral("plus"), QKeySequence::New);
  open = add(tr("Open…"), QStringLiteral("folder"), QKeySequence::Open);
  openResults = add(tr("Open results…"), QStringLiteral("results"), QKeySequence(tr("Ctrl+Shift+O")));
  save = add(tr("Save"), QStringLiteral("file"), QKeySequence::Save);
  saveAs = add(tr("Save as…"), {}, QKeySequence(tr("Ctrl+Shift+S")));
  savePicture = add(tr("Save picture…"), QStringLiteral("camera"), QKeySequence(tr("Ctrl+Shift+P")));
  saveFilm = add(tr("Save film…"), QStringLiteral("film"), QKeySequence(tr("Ctrl+Shift+M")));
  saveView = add(tr("Save view…"), QStringLiteral("file"));
  openView = add(tr("Open view…"), QStringLiteral("folder"));
  compare = add(tr("Compare with results…"), QStringLiteral("results"));
  saveReport = add(tr("Save report…"), QStringLiteral("report"), QKeySequence(tr("Ctrl+Shift+R")));
  for (const auto& [format, name] : {std::pair(DataFormat::csv, tr("Export tables (CSV)…")),
                                     std::pair(DataFormat::vtu, tr("Export for ParaView (VTU)…")),
                                     std::pair(DataFormat::stl, tr("Export this frame (STL)…")),
                                     std::pair(DataFormat::gltf, tr("Export for the web (glTF)…"))})
    exports.emplace_back(format, add(name, QStringLiteral("export")));
  startPage = add(tr("Start page"), QStringLiteral("home"));
  quit = add(tr("Quit"), {}, QKeySequence::Quit);
  QUndoStack& stack = session_.project.document().undoStack();
  undo = stack.createUndoAction(this, tr("Undo"));
  redo = stack.createRedoAction(this, tr("Redo"));
  undo->setIcon(theme::icon(QStringLiteral("undo")));
  redo->setIcon(theme::icon(QStringLiteral("redo")));
  undo->setShortcut(QKeySequence::Undo);
  redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
  for (auto* action : {undo, redo}) {
    window_.addAction(action);
    all_.push_back(action);
  }
  clearSelection = add(tr("Clear selection"), {}, QKeySequence(Qt::Key_Escape));
  connect(clearSelection, &QAction::triggered, this, [this] {
    if (session_.picking.isAsking())
      session_.picking.cancel();
    else
      session_.project.selection().clear();
  });
  connect(save, &QAction::triggered, this, [this] {
    if (session_.project.document().file().empty())
      saveAs->trigger();
    else
      session_.project.save();
  });
}

void WindowActions::makeViewActions() {
  fit = add(tr("Fit all"), QStringLiteral("fit"), QKeySequence(Qt::Key_Home));
  iso = add(tr("From the south-west"), QStringLiteral("blocks"), QKeySequence(Qt::Key_0));
  front = add(tr("From the south"), {}, QKeySequence(Qt::Key_1));
  side = add(tr("From the east"), {}, QKeySequence(Qt::Key_3));
  top = add(tr("From above"), {}, QKeySequence(Qt::Key_7));
  projection = add(tr("Perspective or parallel"), QStringLiteral("perspective"), QKeySequence(Qt::Key_5));
  hide = add(tr("Hide what is selected"), QStringLiteral("eye-off"), QKeySequence(Qt::Key_H));
  isolate = add(tr("Show what is selected alone"), QStringLiteral("eye"), QKeySequence(Qt::Key_I));
  showAll = add(tr("Show all blocks"), {}, QKeySequence(Qt::Key_A));
  explode = add(tr("Draw blocks apart"), QStringLiteral("blocks"), QKeySequence(Qt::Key_E));
  section = add(tr("Cut open across the view"), {}, QKeySequence(Qt::Key_X));
  section->setCheckable(true);
  connect(&session_.display, &Display::changed, section,
          [this] { section->setChecked(session_.display.settings().section.has_value()); });
  showJoints = add(tr("Show joints"), QStringLiteral("joints"), QKeySequence(Qt::Key_J));
  showJoints->setCheckable(true);
  showJoints->setChecked(session_.display.settings().joints);
  connect(showJoints, &QAction::toggled, this, [this](bool shown) {
    SceneSettings settings = session_.display.settings();
    settings.joints = shown;
    session_.display.set(settings);
  });
  showActions = add(tr("Show loads, supports and monitors"), QStringLiteral("vectors"), QKeySequence(Qt::Key_G));
  showActions->setCheckable(true);
  showActions->setChecked(session_.display.settings().actions);
  connect(showActions, &QAction::toggled, this, [this](bool shown) {
    SceneSettings settings = session_.display.settings();
    settings.actions = shown;
    session_.display.set(settings);
  });
  dark = add(tr("Light or dark"), {}, QKeySequence(tr("Ctrl+Shift+D")));
  viewAlone = add(tr("The view alone"), {}, QKeySequence(Qt::Key_F11));
  viewAlone->setCheckable(true);
  connect(dark, &QAction::triggered, this, [this] { session_.display.setDark(!session_.display.isDark()); });
}

void WindowActions::makeRunActions() {
  for (const WorkflowPage page : all_pages) {
    const QString key = tr("Ctrl+%1").arg(static_cast<int>(page) + 1);
    auto* action = add(pageCommand(page), QLatin1String(pageKey(page)), QKeySequence(key));
    connect(action, &QAction::triggered, this, [this, page] { session_.display.goTo(page); });
    pages[page] = action;
  }
  stereonet = add(tr("Stereonet…"), QStringLiteral("stereonet"), QKeySequence(tr("Ctrl+Shift+N")));
  pasteJoints = add(tr("Paste joints…"), QStringLiteral("paste"), QKeySequence(tr("Ctrl+Shift+V")));
  mesh = add(tr("Cut and mesh"), QStringLiteral("cut"), QKeySequence(Qt::Key_F4));
  solve = add(tr("Solve"), QStringLiteral("play"), QKeySequence(Qt::Key_F5));
  goOn = add(tr("Go on with the run"), QStringLiteral("play"));
  pause = add(tr("Pause"), QStringLiteral("pause"), QKeySequence(Qt::Key_F6));
  oneStep = add(tr("One step"), QStringLiteral("step"), QKeySequence(Qt::Key_F10));
  stop = add(tr("Stop"), QStringLiteral("stop"), QKeySequence(tr("Shift+F5")));
  SolverJob& job = session_.run.job();
  connect(mesh, &QAction::triggered, &session_.run, &CurrentRun::mesh);
  connect(goOn, &QAction::triggered, &session_.run, &CurrentRun::goOn);
  connect(pause, &QAction::triggered, this, [&job] { job.state() == JobState::paused ? job.resume() : job.pause(); });
  connect(oneStep, &QAction::triggered, this, [&job] {
    job.pause();
    job.oneStep();
  });
  connect(stop, &QAction::triggered, &session_.run, &CurrentRun::stop);
  play = add(tr("Play or pause"), QStringLiteral("play"), QKeySequence(Qt::Key_Space));
  previousFrame = add(tr("Previous frame"), QStringLiteral("step-back"), QKeySequence(Qt::Key_Left));
  nextFrame = add(tr("Next frame"), QStringLiteral("step"), QKeySequence(Qt::Key_Right));
  firstFrame = add(tr("First frame"), QStringLiteral("first"), QKeySequence(tr("Ctrl+Home")));
  lastFrame = add(tr("Last frame"), QStringLiteral("last"), QKeySequence(tr("Ctrl+End")));
  accuracy = add(tr("Accuracy…"), QStringLiteral("report"));
  knownAnswers = add(tr("Known answers…"), QStringLiteral("report"));
  hardCases = add(tr("Hard cases…"), QStringLiteral("blocks"));
  manual = add(tr("Manual"), QStringLiteral("info"), QKeySequence(Qt::Key_F1));
  about = add(tr("About Talus"), QStringLiteral("info"));
}

void WindowActions::drive(Viewport& viewport, Timeline& timeline) {
  connect(fit, &QAction::triggered, &viewport, &Viewport::fit);
  const std::pair<QAction*, View> views[] = {
      {iso, View::iso}, {front, View::front}, {side, View::right}, {top, View::top}};
  for (const auto& [action, view] : views)
    connect(action, &QAction::triggered, &viewport, [&viewport, v = view] { viewport.look(v); });
  connect(projection, &QAction::triggered, &viewport, &Viewport::toggleProjection);
  connect(hide, &QAction::triggered, &viewport, &Viewport::hideSelected);
  connect(isolate, &QAction::triggered, &viewport, &Viewport::isolateSelected);
  connect(showAll, &QAction::triggered, &viewport, &Viewport::showAll);
  connect(explode, &QAction::triggered, &viewport, &Viewport::toggleExplosion);
  connect(section, &QAction::triggered, &viewport, &Viewport::toggleSection);
  connect(blocks->lasso, &QAction::toggled, &viewport, &Viewport::setLasso);
  connect(play, &QAction::triggered, &timeline, &Timeline::togglePlay);
  connect(previousFrame, &QAction::triggered, &timeline, [&timeline] { timeline.stepBy(-1); });
  connect(nextFrame, &QAction::triggered, &timeline, [&timeline] { timeline.stepBy(1); });
  connect(firstFrame, &QAction::triggered, &timeline, &Timeline::goToFirst);
  connect(lastFrame, &QAction::triggered, &timeline, &Timeline::goToLast);
}

void WindowActions::fill(QMenuBar& bar, QMenu* recent) {
  auto menu = [&bar](const QString& title, std::initializer_list<QAction*> entries) {
    auto* made = bar.addMenu(title);
    made->setToolTipsVisible(true);
    for (auto* entry : entries) {
      if (entry)
        made->addAction(entry);
      else
        made->addSeparator();
    }
    return made;
  };
  auto* file = menu(tr("File"), {newProject, open, openResults, save, saveAs, nullptr, savePicture, saveFilm,
                                 saveReport, nullptr, startPage, quit});
  file->insertMenu(save, recent);
  auto* edit = menu(tr("Edit"), {undo, redo, nullptr, clearSelection, nullptr});
  for (auto* action : blocks->all()) edit->addAction(action);
  auto* view = menu(tr("View"), {fit, iso, front, side, top, projection, nullptr, hide, isolate, showAll, explode,
                                 section, showJoints, showActions, nullptr, dark, viewAlone});
  view->addMenu(new LanguageMenu(session_.messages, view));
  auto* model = menu(tr("Model"), {});
  for (const auto& [page, action] : pages)
    if (isSetUp(page)) model->addAction(action);
  model->addSeparator();
  model->addAction(solids->importGeometry);
  auto* newSolids = model->addMenu(tr("New solid"));
  auto* changed = model->addMenu(tr("Change solids"));
  for (auto* submenu : {newSolids, changed}) submenu->setToolTipsVisible(true);
  solids->addNew(*newSolids);
  solids->addChanges(*changed);
  model->addAction(solids->measure);
  model->addSeparator();
  model->addActions({stereonet, pasteJoints});
  for (auto* action : joints->all()) model->addAction(action);
  model->addSeparator();
  auto* made = model->addMenu(tr("Loads and supports"));
  made->setToolTipsVisible(true);
  for (auto* action : loads->all()) {
    if (action == loads->holdPoint || action == loads->velocity || action == loads->monitor) made->addSeparator();
    made->addAction(action);
  }
  model->addSeparator();
  model->addAction(mesh);
  menu(tr("Solve"), {pages.at(WorkflowPage::solve), nullptr, solve, goOn, pause, oneStep, stop});
  auto* results = menu(tr("Results"),
                       {pages.at(WorkflowPage::results), nullptr, play, previousFrame, nextFrame, firstFrame, lastFrame,
                        nullptr, savePicture, saveFilm, saveReport, nullptr, saveView, openView, nullptr});
  for (const auto& [format, action] : exports) results->addAction(action);
  results->addSeparator();
  results->addActions({compare, accuracy});
  menu(tr("Help"), {manual, nullptr, knownAnswers, hardCases, nullptr, about});
}

void WindowActions::refresh() {
  const bool isOpen = session_.project.document().isOpen();
  const QString noProject = isOpen ? QString() : tr("Open a project first");
  const bool isEmpty = !session_.project.system() && !session_.surfaces.current();
  const QString nothingSeen = isEmpty ? tr("There is no rock yet") : QString();
  const QString noFrames = session_.playback.times().empty() ? tr("Nothing has been solved yet") : QString();
  const JobState state = session_.run.job().state();
  const bool running = state == JobState::running, paused = state == JobState::paused;
  const QString notRunning = running || paused ? QString() : tr("Nothing runs");
  const Selection& selection = session_.project.selection();
  const QString nothingSelected =
      selection.blocks().empty() && selection.solids().empty() ? tr("Select a block or a solid first") : QString();
  allow(*startPage, {});
  for (auto* action : {newProject, open, openResults})
    allow(*action, session_.run.job().isBusy() ? tr("A run goes on: stop it first") : QString());
  allow(*save, !isOpen ? noProject
               : session_.project.document().isSaved() && !session_.project.document().file().empty()
                   ? tr("Nothing has changed since it was saved")
                   : QString());
  for (auto* action : {saveAs, stereonet, pasteJoints}) allow(*action, noProject);
  allow(*savePicture, nothingSeen);
  allow(*saveFilm, noFrames);
  const bool isLive = session_.playback.isLive();
  const QString noResults = isLive ? tr("The run goes on: its results are complete at its end") : noFrames;
  allow(*saveReport, noResults);
  for (auto* action : {saveView, openView}) allow(*action, noFrames);
  allow(*compare, noResults);
  for (const auto& [format, action] : exports) allow(*action, noResults);
  for (auto* action : {fit, iso, front, side, top, projection, showAll, explode, section, showActions})
    allow(*action, nothingSeen);
  for (auto* action : {hide, isolate}) allow(*action, nothingSelected);
  for (auto* action : blocks->all()) allow(*action, blocks->whyNot(action));
  allow(*showJoints, noProject);
  for (auto* action : joints->all()) allow(*action, joints->whyNot(action));
  for (auto* action : loads->all()) allow(*action, loads->whyNot());
  allow(*mesh, session_.whyNotMesh());
  const QString whyNotSolve = session_.run.whyNotSolve();
  allow(*solve, whyNotSolve);
  allow(*goOn, !whyNotSolve.isEmpty()      ? whyNotSolve
               : session_.run.checkpoint() ? QString()
                                           : tr("No run of this project was stopped that could go on"));
  pause->setText(paused ? tr("Resume") : tr("Pause"));
  pause->setIcon(theme::icon(paused ? QStringLiteral("play") : QStringLiteral("pause")));
  allow(*pause, notRunning);
  allow(*oneStep, notRunning);
  allow(*stop, session_.run.whyNotStop());
  for (auto* action : {play, previousFrame, nextFrame, firstFrame, lastFrame}) allow(*action, noFrames);
  for (const auto& [page, action] : pages) allow(*action, noProject);
  for (auto* action : {dark, viewAlone, clearSelection, quit, accuracy, manual, knownAnswers, hardCases, about})
    allow(*action, {});
}

}  // namespace talus
