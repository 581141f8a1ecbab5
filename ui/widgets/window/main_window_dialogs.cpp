// The window's dialogs: which file to open, where to save, what is lost.
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QRegularExpression>
#include <QStackedWidget>

#include "base/error.hpp"
#include "verification/hard_cases/scenes/all_hard_cases.hpp"
#include "widgets/begin/recent_files.hpp"
#include "widgets/begin/samples.hpp"
#include "widgets/geometry/solid_tools.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/orientation/paste_joints.hpp"
#include "widgets/orientation/stereonet_panel.hpp"
#include "widgets/project/project_tree.hpp"
#include "widgets/results/film_dialog.hpp"
#include "widgets/study/accuracy_panel.hpp"
#include "widgets/verification/verification.hpp"
#include "widgets/view/viewport.hpp"
#include "widgets/window/guards.hpp"
#include "widgets/window/main_window.hpp"
#include "widgets/window/manual_window.hpp"
#include "widgets/window/top_bar.hpp"
#include "widgets/window/window_actions.hpp"

namespace talus {

namespace {

/// The chosen name with `ending` where the user gave none.
std::filesystem::path withEnding(const QString& name, const char* ending) {
  std::filesystem::path path(name.toStdString());
  if (!path.has_extension()) path += ending;
  return path;
}

}  // namespace

void MainWindow::connectActions() {
  connect(actions_->newProject, &QAction::triggered, this, [this] { newProject(); });
  connect(actions_->solve, &QAction::triggered, this, &MainWindow::solve);
  connect(actions_->open, &QAction::triggered, this, &MainWindow::askForProject);
  connect(actions_->openResults, &QAction::triggered, this, &MainWindow::askForResults);
  connect(actions_->saveAs, &QAction::triggered, this, &MainWindow::saveAs);
  connect(actions_->savePicture, &QAction::triggered, this, &MainWindow::askForPicture);
  connect(actions_->saveFilm, &QAction::triggered, this, &MainWindow::askForFilm);
  connect(actions_->compare, &QAction::triggered, this, &MainWindow::askForComparison);
  connect(actions_->saveReport, &QAction::triggered, this, &MainWindow::askForReport);
  connect(actions_->saveView, &QAction::triggered, this, [this] { askForView(true); });
  connect(actions_->openView, &QAction::triggered, this, [this] { askForView(false); });
  for (const auto& [format, action] : actions_->exports)
    connect(action, &QAction::triggered, this, [this, format = format] { askForExport(format); });
  connect(actions_->startPage, &QAction::triggered, this, [this] { showStart(true); });
  connect(actions_->clearSelection, &QAction::triggered, this, [this] {  // Esc leaves the start page
    if (centre_->currentIndex() == 0 && session_.project.document().isOpen()) showStart(false);
  });
  connect(actions_->quit, &QAction::triggered, this, &QWidget::close);
  for (const auto& [action, list] : {std::pair(actions_->knownAnswers, Verification::List::knownAnswers),
                                     std::pair(actions_->hardCases, Verification::List::hardCases)})
    connect(action, &QAction::triggered, this, [this, list = list] {
      if (auto* dialog = verification()) dialog->open(list);
    });
  connect(actions_->accuracy, &QAction::triggered, this, &MainWindow::showAccuracy);
  connect(actions_->stereonet, &QAction::triggered, this, &MainWindow::showStereonet);
  connect(actions_->pasteJoints, &QAction::triggered, this, &MainWindow::askForJoints);
  connect(actions_->solids, &SolidTools::projectWanted, this, &MainWindow::beginBeside);
  connect(viewport_, &Viewport::rockWanted, actions_->solids->importGeometry, &QAction::trigger);
  connect(viewport_, &Viewport::menuWanted, this, &MainWindow::showMenu);
  connect(tree_, &ProjectTree::menuWanted, this, &MainWindow::showMenu);
  connect(actions_->manual, &QAction::triggered, this, &MainWindow::showManual);
  connect(actions_->about, &QAction::triggered, this, &MainWindow::showAbout);
  connect(actions_->viewAlone, &QAction::toggled, this, &MainWindow::showViewAlone);
  connect(topBar_->recentMenu(), &QMenu::aboutToShow, this, &MainWindow::showRecent);
}

/// What can be done with what is selected.
void MainWindow::showMenu(const QPoint& at) {
  QMenu menu;
  menu.setToolTipsVisible(true);
  if (session_.project.selection().current().kind == Item::Kind::solid) {
    actions_->solids->addChanges(menu);
    menu.addSeparator();
  }
  menu.addActions({actions_->isolate, actions_->hide, actions_->showAll, actions_->fit});
  menu.exec(at);
}

QString MainWindow::folderForDialogs() const {
  const Document& document = session_.project.document();
  return document.file().empty() ? QString() : text(document.folder().string());
}

QString MainWindow::proposedFile(const QString& ending) const {
  const Document& document = session_.project.document();
  if (!document.file().empty()) return text((document.folder() / document.file().stem()).string()) + ending;
  static const QRegularExpression no_letter(QStringLiteral("[^\\p{L}\\p{N}]+"));
  QString name = document.name().replace(no_letter, QStringLiteral(" ")).trimmed().toLower();
  return name.isEmpty() ? name : name.replace(u' ', u'_') + ending;
}

void MainWindow::showRecent() {
  auto* menu = topBar_->recentMenu();
  menu->clear();
  for (const RecentFile& file : recentFiles())
    if (file.isThere) menu->addAction(text(file.path.string()), this, [this, path = file.path] { open(path); });
  if (menu->isEmpty()) menu->addAction(tr("No file has been opened yet"))->setEnabled(false);
}

void MainWindow::askForProject() {
  const QString name =
      QFileDialog::getOpenFileName(this, tr("Open a project"), folderForDialogs(), tr("Talus projects (*.talus)"));
  if (!name.isEmpty()) open(name.toStdString());
}

void MainWindow::askForResults() {
  const QString name = QFileDialog::getExistingDirectory(this, tr("Open a results folder"), folderForDialogs());
  if (!name.isEmpty()) open(name.toStdString());
}

void MainWindow::askForComparison() {
  const QString name = QFileDialog::getExistingDirectory(this, tr("Compare with a results folder"), folderForDialogs());
  if (!name.isEmpty()) compareWith(name.toStdString());
}

void MainWindow::compareWith(const std::filesystem::path& folder) { session_.compared.open(folder); }

bool MainWindow::saveAs() {
  const QString name = QFileDialog::getSaveFileName(
      this, tr("Save the project"), proposedFile(QStringLiteral(".talus")), tr("Talus projects (*.talus)"));
  if (name.isEmpty() || !session_.project.saveAs(withEnding(name, ".talus"))) return false;
  rememberRecent(session_.project.document().file());
  return true;
}

void MainWindow::solve() {
  if (!session_.run.whyNotSolve().isEmpty()) return;
  if (session_.project.document().file().empty() && !saveAs()) return;  // results lie beside the project
  if (guards_->mayReplaceResults()) session_.solve();
}

void MainWindow::askForPicture() {
  const QString name = QFileDialog::getSaveFileName(this, tr("Save a picture"), proposedFile(QStringLiteral(".png")),
                                                    tr("Pictures (*.png)"));
  if (!name.isEmpty()) savePicture(withEnding(name, ".png"));
}

void MainWindow::askForFilm() {
  if (!film_) {
    film_ = new FilmDialog(session_.playback, session_.compared, *viewport_, *timeline_, session_.messages, this);
    connect(film_, &FilmDialog::filmWanted, this, &MainWindow::askForFilmFile);
  }
  film_->present(session_.project.selection().blocks());
}

void MainWindow::askForFilmFile() {
  const QString name = QFileDialog::getSaveFileName(this, tr("Save a film"), proposedFile(QStringLiteral(".mp4")),
                                                    tr("Films (*.mp4 *.gif)"));
  if (!name.isEmpty()) saveFilm(withEnding(name, ".mp4"), film_->options());
}

void MainWindow::askForReport() {
  const QString name = QFileDialog::getSaveFileName(this, tr("Save a report"), proposedFile(QStringLiteral(".html")),
                                                    tr("Reports (*.html *.pdf)"));
  if (!name.isEmpty()) saveReport(withEnding(name, ".html"));
}

void MainWindow::askForView(bool save) {
  const QString kind = tr("Views of results (*.json)");
  if (save) {
    const QString name =
        QFileDialog::getSaveFileName(this, tr("Save the view"), proposedFile(QStringLiteral(".view.json")), kind);
    if (!name.isEmpty()) saveView(withEnding(name, ".json"));
  } else {
    const QString name = QFileDialog::getOpenFileName(this, tr("Open a view"), folderForDialogs(), kind);
    if (!name.isEmpty()) openView(name.toStdString());
  }
}

void MainWindow::saveView(const std::filesystem::path& path) {
  auto view = viewport_->savedView();
  if (!view) return;
  if (const auto& runs = session_.compared.runs(); !runs.empty()) {  // all that stands side by side
    view->width = qRound(views_->width() * devicePixelRatioF());
    view->height = qRound(views_->height() * devicePixelRatioF());
    for (const auto& run : runs) view->beside.push_back({run->results()->folder, session_.compared.isOver(*run)});
  }
  session_.messages.settle(Problem::Of::picture);
  try {
    save_view(*view, path);
    session_.messages.log(tr("Saved the view as %1").arg(text(path.string())));
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error, Problem::Of::picture));
  }
}

void MainWindow::openView(const std::filesystem::path& path) {
  session_.messages.settle(Problem::Of::picture);
  try {
    const SavedView view = read_view(path);
    session_.display.goTo(WorkflowPage::results);
    viewport_->show(view);
    session_.compared.show(view.beside);
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error, Problem::Of::picture));
  }
}

void MainWindow::askForExport(DataFormat format) {
  const bool isFolder = format == DataFormat::csv || format == DataFormat::vtu;
  const char* ending = format == DataFormat::csv   ? ".csv"
                       : format == DataFormat::vtu ? ".vtu"
                       : format == DataFormat::stl ? ".stl"
                                                   : ".glb";
  const QString name = QFileDialog::getSaveFileName(
      this, isFolder ? tr("A new folder for the files") : tr("Export"), proposedFile(QString::fromLatin1(ending)),
      isFolder ? tr("New folders (*)") : tr("Files (*%1)").arg(QString::fromLatin1(ending)));
  if (!name.isEmpty()) exportData(format, withEnding(name, isFolder ? "" : ending));
}

Verification* MainWindow::verification() {
  if (verification_) return verification_;
  try {
    verification_ = new Verification(all_cases(samplesFolder()), hard_cases(), this);
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error));
  }
  return verification_;
}

void MainWindow::showAccuracy() {
  if (!accuracy_) accuracy_ = new AccuracyPanel(session_.project, session_.run, session_.study, this);
  accuracy_->present();
}

void MainWindow::showStereonet() {
  if (!stereonet_) {
    stereonet_ = new StereonetPanel(session_.project, session_.joints, session_.messages, session_.display,
                                    session_.picking, this);
    connect(stereonet_, &StereonetPanel::pasteWanted, this, &MainWindow::askForJoints);
  }
  stereonet_->present();
}

PasteJoints& MainWindow::pasteJoints() {
  if (!pasteJoints_) pasteJoints_ = new PasteJoints(session_.project.document(), session_.surfaces, this);
  return *pasteJoints_;
}

void MainWindow::askForJoints() { pasteJoints().present(); }

void MainWindow::takeJoints(const std::filesystem::path& file) { pasteJoints().presentFile(file); }

void MainWindow::showManual() {
  if (!manual_) manual_ = new ManualWindow(this);
  manual_->present(manualHeading(session_.display.page(), session_.project.selection().current().kind));
}

void MainWindow::showAbout() {
  QMessageBox::about(this, tr("About Talus"),
                     tr("<b>Talus %1</b><p>Rock slopes that come apart along joints: three-dimensional discontinuous "
                        "deformation analysis with tetrahedral finite elements.</p><p>GPL-3.0-or-later. Built on Qt, "
                        "VTK, gmsh, SuiteSparse, HDF5 and FFmpeg. Typeface Inter, OFL 1.1.</p>")
                         .arg(QStringLiteral(TALUS_VERSION)));
}

}  // namespace talus
