#include "every_place.hpp"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QCompleter>
#include <QFile>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPainter>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <fstream>
#include <nlohmann/json.hpp>

#include "document/item_place.hpp"
#include "document/recovery.hpp"
#include "example_projects.hpp"
#include "study/accuracy/accuracy_files.hpp"
#include "study/accuracy/study_record.hpp"
#include "unit/io/sample_project.hpp"
#include "widgets/begin/new_dialog.hpp"
#include "widgets/begin/project_preview.hpp"
#include "widgets/begin/recovery_offer.hpp"
#include "widgets/geometry/import_dialog.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/orientation/stereonet_panel.hpp"
#include "widgets/orientation/stereonet_view.hpp"
#include "widgets/view/compared_viewport.hpp"
#include "widgets/window/bottom_panel.hpp"
#include "widgets/window/command_search.hpp"
#include "widgets/window/units_button.hpp"

namespace talus {

namespace {

void type(QWidget& among, const QString& field, const QString& number) {
  for (auto* one : among.findChildren<NumberField*>()) {
    if (one->accessibleName() != field) continue;
    one->setFocus();
    one->selectAll();
    QTest::keyClicks(one, number);
    QTest::keyClick(one, Qt::Key_Return);
    return;
  }
  ADD_FAILURE() << "no field is called " << field.toStdString();
}

void choose(QWidget& among, const char* box, int entry) {
  for (auto* one : among.findChildren<QComboBox*>()) {
    if (one->accessibleName() != QLatin1String(box) && one->objectName() != QLatin1String(box)) continue;
    one->setCurrentIndex(entry);
    emit one->activated(entry);
    return;
  }
  ADD_FAILURE() << "no choice is called " << box;
}

/// The same of an entry by its words.
void choose(QWidget& among, const char* box, const QString& entry) {
  const auto* one = among.findChild<QComboBox*>(QLatin1String(box));
  choose(among, box, one ? one->findText(entry) : -1);
}

/// Gives a run of a study the seconds that its iterations would take on a machine that is always as fast.
void takeAsLongAsEver(const std::filesystem::path& run) {
  nlohmann::json json = nlohmann::json::parse(std::ifstream(run));
  const double seconds = 1e-3 * json["iterations"].get<double>();
  json["cpu_seconds"] = json["wall_seconds"] = seconds;
  json["mesh_seconds"] = 0.2;
  for (auto& phase : json["phases"]) phase = 0.15 * seconds;
  for (auto& effect : json["effects"])
    if (effect["active"]) effect["seconds"] = 0.1 * seconds;
  std::ofstream(run) << json;
}

}  // namespace

void EveryPlace::visitAll(const QSize& size, Look look) {
  look_ = std::move(look);
  slope_ = write("quarry.talus", example::slope);
  window->resize(size);
  rest(50);
  begin();
  importGeometry();
  setUp();
  orient();
  cutAndMesh();
  act();
  openMenus();
  everyForm();
  showTroubles();
  solve();
  studyAndVerify();
}

void EveryPlace::begin() {
  look("start");
  for (const char* key : {empty_key, "bench-slope", "wedge", "cavern"}) {
    window->newProject(key);
    rest(50);
    wait([&] { return shown<ProjectPreview>().isUpToDate(); });
    look(std::string("new-") + key);
    closeAll();
  }
  std::vector<Leftover> left(2);
  left[0].name = QStringLiteral("Quarry, north face");
  left[1].name = QStringLiteral("Survey of May");
  for (Leftover& one : left) one.when = QDateTime(QDate(2026, 5, 12), QTime(14, 8));
  left[0].draft.file = slope_;
  auto* offer = new RecoveryOffer(left, window.get());
  offer->setAttribute(Qt::WA_DeleteOnClose);
  offer->open();
  look("recovery");
  closeAll();
  open(write("empty.talus", "{\"talus\": 1, \"materials\": {}, \"solids\": [], \"stages\": []}"));
  for (const WorkflowPage page : all_pages) look(std::string("empty-") + pageKey(page), page);
  window->findChild<BottomPanel*>()->showProblems();
  look("empty-problems");
}

void EveryPlace::importGeometry() {
  const auto import = [&](const std::filesystem::path& file) -> ImportDialog& {
    window->takeDropped(file);
    auto& dialog = shown<ImportDialog>();
    wait([&] { return !dialog.isReading(); });
    rest(100);  // the preview is made
    return dialog;
  };
  import(std::filesystem::path(TALUS_SOURCE_DIR) / "samples/step_slope/slope.step");
  look("import-step");
  closeAll();
  import(write("land.asc", example::hillside()));
  look("import-terrain");
  closeAll();
  import(write("prism.stl", example::open_prism()));
  look("import-open-surface");
  closeAll();
  import(write("rubbish.stl", "solid nothing\nendsolid nothing\n"));
  look("import-refused");
  closeAll();
}

void EveryPlace::setUp() {
  open(slope_);
  wait([&] { return session->surfaces.current() && !session->surfaces.isBusy(); });
  window->viewport().fit();
  look("geometry", WorkflowPage::geometry);
  look("geometry-section", WorkflowPage::geometry, {Item::Kind::solid, 1});
  look("section-editor", "Edit section…");
  for (const auto& [place, words] : {std::pair("move", "Move solids…"),
                                     {"turn", "Turn solids…"},
                                     {"scale", "Scale solids…"},
                                     {"copy", "Copy solids…"}})
    look(place, words);
  command("Measure");
  look("measure-asks");
  pick(-1, {12, 2, 6});
  pick(-1, {20, 2, 24});
  look("measure");
  session->picking.cancel();
  closeAll();
  look("joints", WorkflowPage::joints);
  look("joints-joint", WorkflowPage::joints, {Item::Kind::joint, 0});
  look("joints-cut", WorkflowPage::joints, {Item::Kind::cut, 1});
  command("Joint through three points");
  look("joints-three-points");
  session->picking.cancel();
  look("materials", WorkflowPage::materials, {Item::Kind::material, 1});
  look("stages", WorkflowPage::stages, {Item::Kind::stage, 1});
  look("solver", WorkflowPage::stages, {Item::Kind::solver, 0});
}

void EveryPlace::orient() {
  open(write("survey.talus", example::survey));
  look("joints-survey", WorkflowPage::joints, {Item::Kind::cut, 0});
  look("joints-network", WorkflowPage::joints, {Item::Kind::cut, 3});
  look("stereonet", "Stereonet…");
  command("Stereonet…");
  auto& net = shown<StereonetPanel>();
  type(net, QStringLiteral("Face dip"), QStringLiteral("65"));
  type(net, QStringLiteral("Face dip direction"), QStringLiteral("140"));
  auto& view = *net.findChild<StereonetView*>();
  const QPoint from = view.pointOf(pole_of({30, 115})).toPoint(), to = view.pointOf(pole_of({55, 165})).toPoint();
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(&view, &move);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  for (int mode = 0; mode < 4; ++mode) {
    choose(net, "Failure mode that is shown", mode);
    choose(net, "Projection", mode % 2);
    choose(net, "Density", mode % 3);
    look("stereonet-mode-" + std::to_string(mode + 1));
  }
  closeAll();
  QApplication::clipboard()->setText(
      QString::fromUtf8("Dip;Dip dir;Set;X;Y;Z;Trace [m]\n45,5°;120°;J1;1;2;3;12\n80;300;J2;4;5;6;\n95;20;J2;;;;\n"));
  look("paste-joints", "Paste joints…");
}

void EveryPlace::cutAndMesh() {
  openAndMesh(slope_);
  window->viewport().fit();
  session->display.goTo(WorkflowPage::blocks);
  wait([&] { return session->survey.facts() != nullptr; });
  look("blocks", WorkflowPage::blocks);
  look("blocks-one", WorkflowPage::blocks, {Item::Kind::block, 2});
  session->project.selection().selectBlocks({1, 2, 3});
  look("blocks-several");
  look("select-by-rule", "Select by rule…");
  choose(*window, "colour by", 3);
  window->findChild<QSlider*>(QStringLiteral("apart"))->setValue(12);
  look("blocks-apart");
  choose(*window, "colour by", 0);
  window->findChild<QSlider*>(QStringLiteral("apart"))->setValue(0);
  look("mesh", WorkflowPage::mesh);
  look("mesh-settings", WorkflowPage::mesh, {Item::Kind::mesh, 0});
}

void EveryPlace::act() {
  look("loads", WorkflowPage::loads);
  look("loads-curve", WorkflowPage::loads, {Item::Kind::load, 0});
  look("loads-force", WorkflowPage::loads, {Item::Kind::load, 1});
  look("loads-support", WorkflowPage::loads, {Item::Kind::constraint, 0});
  look("loads-velocity", WorkflowPage::loads, {Item::Kind::velocity, 0});
  look("loads-in-situ", WorkflowPage::loads, {Item::Kind::inSitu, 0});
  look("loads-monitor", WorkflowPage::loads, {Item::Kind::monitor, 0});
  look("expectation", WorkflowPage::loads, {Item::Kind::expectation, 0});
  command("Load on a face…");
  look("load-asks");
  pick(5, {22, 3, 24.125}, Vec3(-1, 0, 16).normalized());
  look("load-new");
  closeAll();
  session->project.selection().selectBlocks({5});
  look("velocity-new", "Velocity of blocks…");
}

void EveryPlace::openMenus() {
  auto* bar = window->findChild<QMenuBar*>();
  int number = 0;
  for (QAction* title : bar->actions())
    lookAt("menu-" + std::to_string(++number), *title->menu(),
           bar->mapToGlobal(bar->actionGeometry(title).bottomLeft()));
  auto& units = *window->findChild<UnitsButton*>();
  lookAt("menu-units", *units.menu(), units.mapToGlobal(QPoint(0, -units.menu()->sizeHint().height())));
  auto& search = *window->findChild<CommandSearch*>();
  search.begin();
  QTest::keyClicks(&search, QStringLiteral("joint"));
  look("commands");
  search.clear();
  search.completer()->popup()->hide();
  look("manual", "Manual");
  lookAtQuestion("about", [&] { command("About Talus"); });
  command("The view alone");
  look("view-alone");
  command("The view alone");
}

/// Each form of a project that has everything.
void EveryPlace::everyForm() {
  open(write("full.talus", test::full_project));
  wait([&] { return !session->project.problems().isReading() && !session->surfaces.isBusy(); });
  for (int kind = 1; kind <= static_cast<int>(Item::Kind::output); ++kind)
    for (int index = 0; index < 7; ++index) {
      const Item item{static_cast<Item::Kind>(kind), index};
      if (!listKey(item.kind) || !exists(item, session->project.document().json())) continue;
      if (isOneThing(item.kind) && index > 0) continue;
      look(std::string("form-") + listKey(item.kind) + '-' + std::to_string(index + 1),
           item.kind == Item::Kind::stage ? WorkflowPage::stages : WorkflowPage::loads, item);
    }
  window->findChild<BottomPanel*>()->showProblems();
  look("problems");
}

void EveryPlace::showTroubles() {
  open(write("splinters.talus", example::splinters));
  session->display.goTo(WorkflowPage::blocks);
  session->run.mesh();
  waitForRun([&] { return !session->run.job().isBusy(); });
  window->viewport().fit();
  look("splinters");
  openAndMesh(write("dropped.talus", example::dropped));
  session->solve();
  waitForRun([&] { return !session->run.job().isBusy() && session->playback.frame(); });
  look("trouble-results");
  look("trouble-solve", WorkflowPage::solve);
}

void EveryPlace::solve() {
  openAndMesh(slope_);
  window->viewport().fit();
  look("solve-ready", WorkflowPage::solve);
  session->solve();
  waitForRun([&] { return !session->run.steps().empty(); });
  session->run.job().pause();
  takeSteps(15);
  look("solve-paused", WorkflowPage::solve);
  lookAtQuestion("close-while-running", [&] { window->close(); });
  session->run.job().resume();
  waitForRun([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); });
  look("solve-done", WorkflowPage::solve);
  session->playback.showTime(0.8);
  wait([&] { return !session->playback.isWaiting(); });
  look("results", WorkflowPage::results);
  choose(*window, "field", QStringLiteral("Stress"));
  wait([&] { return session->display.knowsRangeOfRun(); });
  look("results-stress");
  choose(*window, "field", QStringLiteral("Joints"));
  wait([&] { return session->display.knowsRangeOfRun(); });
  look("results-joints");
  choose(*window, "field", QStringLiteral("Displacement"));
  auto* bottom = window->findChild<BottomPanel*>();
  bottom->setCurrentIndex(0);
  look("results-table");
  bottom->setCurrentIndex(bottom->count() - 1);
  look("results-log");
  window->saveFilm(folder / "slide.mp4");
  look("film");
  wait([&] { return !session->playback.isExporting(); });
  look("film-dialog", "Save film…");
  measureResults();
  compareResults();
  QFile results(QString::fromStdString((session->playback.folder() / "results.h5").string()));
  results.open(QIODevice::ReadWrite);
  results.setFileTime(QDateTime(QDate(2026, 5, 12), QTime(14, 8)), QFileDevice::FileModificationTime);
  results.close();
  lookAtQuestion("replace-results", [&] { command("Solve"); });
  Project changed = session->project.document().project();
  changed.name = "Quarry, changed";
  session->project.document().change(changed, QStringLiteral("change the name"));
  look("results-stale", WorkflowPage::results);
  lookAtQuestion("unsaved", [&] { window->newProject(); });
  session->project.document().undoStack().undo();
  command("Start page");
  look("start-recent");
  QTest::keyClick(window.get(), Qt::Key_Escape);
}

void EveryPlace::measureResults() {
  auto* bottom = window->findChild<BottomPanel*>();
  session->project.selection().select({Item::Kind::block, 2});
  const auto lookAtTab = [&](const char* title, const char* place, auto isKnown) {
    for (int tab = 0; tab < bottom->count(); ++tab)
      if (bottom->tabText(tab) == QLatin1String(title)) bottom->setCurrentIndex(tab);
    EXPECT_TRUE(wait(isKnown)) << title;
    look(place);
  };
  lookAtTab("Histories", "results-histories", [] { return true; });
  lookAtTab("Blocks' histories", "results-block-histories", [&] { return session->histories.history() != nullptr; });
  lookAtTab("Run-out", "results-run-out", [&] { return session->slide.slide() != nullptr; });
  lookAtTab("Joints that slipped", "results-slipped", [&] { return session->slips.slips() != nullptr; });
  lookAtTab("Along a line", "results-line", [] { return true; });
  session->project.selection().select({});
  bottom->setCurrentIndex(bottom->count() - 1);
}

void EveryPlace::compareResults() {
  const auto& runs = session->compared.runs();
  for (const char* name : {"dry.results", "wet.results", "bolted.results"}) {
    std::filesystem::copy(session->playback.folder(), folder / name, std::filesystem::copy_options::recursive);
    const std::size_t before = runs.size();
    window->compareWith(folder / name);
    EXPECT_TRUE(wait([&] { return runs.size() > before; }));
    for (const auto* view : window->findChildren<ComparedViewport*>())
      EXPECT_TRUE(wait([&] { return view->scene() && view->run().frame(); }));
    if (before == 0) look("results-beside");
  }
  look("results-four");
  while (!runs.empty()) session->compared.close(*runs.front());
}

/// Of a run that is to pause, until it has made as many; the one that is under way ends first.
void EveryPlace::takeSteps(std::size_t count) {
  constexpr int longer_than_a_step = 2000;  // ms
  std::size_t made = 0;
  for (QElapsedTimer still; !still.isValid() || still.elapsed() < longer_than_a_step; rest(50))
    if (const std::size_t now = session->run.steps().size(); now != made) {
      made = now;
      still.start();
    }
  while (session->run.steps().size() < count) {
    const std::size_t before = session->run.steps().size();
    session->run.job().oneStep();
    ASSERT_TRUE(wait([&] { return session->run.steps().size() > before; }));
  }
}

void EveryPlace::studyAndVerify() {
  open(sample("free_fall"));
  look("accuracy-none", "Accuracy…");
  const auto file = slidingCube(100);
  const StudyFolder made(std::filesystem::path(file).replace_extension(".accuracy"),
                         make_plan({file, false, parse_ladder_wish({}, {"time_step=4,2,1,0.5"}), "test"}), false);
  NoProgress nobody;
  for (const int run : made.missing_runs()) {
    perform_study_run(made, run, nobody);
    takeAsLongAsEver(made.run_file(run));
  }
  std::ofstream(made.path() / "accuracy.json") << accuracy_json(evaluate(made, std::nullopt));
  openAndMesh(file);
  look("accuracy", "Accuracy…");
  look("solve-studied", WorkflowPage::solve);
  look("known-answers", "Known answers…");
  look("hard-cases", "Hard cases…");
}

QPixmap EveryPlace::picture() const {
  const QString own = QString::fromStdString(folder.string()) + u'/';  // of this test; it says nothing in a picture
  for (auto* label : window->findChildren<QLabel*>())
    if (label->text().contains(own)) label->setText(label->text().remove(own));
  QPixmap whole = window->grab();
  QPainter painter(&whole);
  for (QWidget* over : QApplication::topLevelWidgets())
    if (over != window.get() && over->isVisible()) {
      // The platform's screen is smaller than the window: dialogs are put into its middle here.
      const QPoint place = over->mapToGlobal(QPoint()) - window->mapToGlobal(QPoint());
      const QSize left = (window->size() - over->size()) / 2;
      const QPoint at = over->inherits("QDialog") ? QPoint(left.width(), left.height()) : place;
      painter.drawPixmap(at, over->grab());
      painter.setPen(QColor(128, 128, 128));
      painter.drawRect(QRect(at, over->size()).adjusted(-1, -1, 0, 0));
    }
  return whole;
}

void EveryPlace::open(const std::filesystem::path& file) {
  window->open(file);
  const auto& problems = session->messages.problems();
  if (!problems.empty()) throw std::runtime_error((problems[0].place + u' ' + problems[0].problem).toStdString());
}

void EveryPlace::look(const std::string& place) {
  rest(40);
  // Words that came just now, from a check in the background too, have found their place.
  QApplication::sendPostedEvents();
  look_(place);
}

void EveryPlace::look(const std::string& place, WorkflowPage page, const Item& item) {
  session->display.goTo(page);
  session->project.selection().select(item);
  look(place);
}

void EveryPlace::look(const std::string& place, const char* words) {
  command(words);
  look(place);
  closeAll();
}

void EveryPlace::lookAt(const std::string& place, QMenu& menu, const QPoint& at) {
  menu.popup(at);
  look(place);
  menu.close();
}

void EveryPlace::command(const char* words) {
  for (auto* action : window->findChildren<QAction*>())
    if (action->text() == QString::fromUtf8(words)) {
      EXPECT_TRUE(action->isEnabled()) << action->toolTip().toStdString();
      action->trigger();
      rest(30);
      return;
    }
  ADD_FAILURE() << "no command says " << words;
}

void EveryPlace::closeAll() {
  for (QWidget* over : QApplication::topLevelWidgets())
    if (over != window.get() && over->isVisible()) over->close();
  rest(20);
}

void EveryPlace::lookAtQuestion(const std::string& place, const std::function<void()>& action) {
  bool asked = false;
  QTimer::singleShot(100, window.get(), [&] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!question) return;
    asked = true;
    look(place);
    question->reject();
  });
  action();
  rest(150);
  EXPECT_TRUE(asked) << place;
}

void EveryPlace::pick(int block, const Vec3& point, const Vec3& normal) {
  session->picking.take({.block = block, .solid = 1, .joint = -1, .point = point, .normal = normal});
  rest(30);
}

}  // namespace talus
