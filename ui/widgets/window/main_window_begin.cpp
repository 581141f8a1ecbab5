// How the window comes to a project: new, opened, a copy, dropped, recovered.
#include <QDragEnterEvent>
#include <QMimeData>
#include <QStackedWidget>
#include <QTimer>
#include <QUrl>

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "io/whole_file.hpp"
#include "widgets/begin/new_dialog.hpp"
#include "widgets/begin/recent_files.hpp"
#include "widgets/begin/recovery_offer.hpp"
#include "widgets/geometry/solid_tools.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/view/viewport.hpp"
#include "widgets/window/guards.hpp"
#include "widgets/window/main_window.hpp"
#include "widgets/window/window_actions.hpp"

namespace talus {

namespace {

bool isTableOfJoints(const std::filesystem::path& path) {
  const QString ending = text(path.extension().string()).toLower();
  return ending == QStringLiteral(".csv") || ending == QStringLiteral(".tsv") || ending == QStringLiteral(".dxf");
}

}  // namespace

void MainWindow::newProject(const std::string& key) {
  if (!session_.isFree(tr("New project")) || !guards_->mayLeaveProject()) return;
  auto* dialog = new NewDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  if (!key.empty()) dialog->choose(key);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    const Project project = dialog->project();
    begin({.text = write_project(project)}, text(project.name));
  });
  dialog->open();
}

bool MainWindow::begin(const Draft& draft, const QString& what) {
  keepPictureOfProject();
  if (!session_.begin(draft, what)) return false;
  if (session_.run.whyNotMesh().isEmpty()) session_.run.mesh();  // so that there is something to be seen
  return true;
}

void MainWindow::open(const std::filesystem::path& path) {
  if (!session_.isFree(text(path.string())) || !guards_->mayLeaveProject()) return;
  keepPictureOfProject();
  if (session_.open(path)) rememberRecent(path);
}

void MainWindow::openCopy(const std::filesystem::path& sample) {
  if (!session_.isFree(text(sample.string())) || !guards_->mayLeaveProject()) return;
  try {
    const auto folder = std::filesystem::absolute(sample).parent_path();
    begin({.text = read_whole_file(sample), .folder = folder, .isWork = false}, text(sample.stem().string()));
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error));
  }
}

void MainWindow::keepPictureOfProject() {
  const Document& document = session_.project.document();
  if (document.file().empty() || !session_.project.system() || !viewport_->isVisible()) return;
  keepPictures(document.file(), viewport_->picture(Theme::light), viewport_->picture(Theme::dark));
}

void MainWindow::offerRecovery() {
  auto found = leftovers();
  if (found.empty()) return;
  auto* offer = new RecoveryOffer(std::move(found), this);
  offer->setAttribute(Qt::WA_DeleteOnClose);
  connect(offer, &RecoveryOffer::recovered, this, [this](const Leftover& leftover) {
    // Kept anew in this window's own place before the old one goes.
    if (guards_->mayLeaveProject() && begin(leftover.draft, leftover.name)) leftover.discard();
  });
  offer->open();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  event->acceptProposedAction();
  // The program that the file comes from waits for the end of this event: no question within it.
  QTimer::singleShot(0, this, [this, urls] {
    for (const QUrl& url : urls) takeDropped(url.toLocalFile().toStdString());
  });
}

/// A project beside a file that is to be imported into it.
void MainWindow::beginBeside(const std::filesystem::path& file) {
  Project project = emptyProject();
  project.name = file.stem().string();
  begin({.text = write_project(project), .folder = std::filesystem::absolute(file).parent_path()}, text(project.name));
}

void MainWindow::takeDropped(const std::filesystem::path& path) {
  std::error_code unknown;
  if (path.extension() == ".talus" || std::filesystem::is_directory(path, unknown)) return open(path);
  if (session_.project.document().isOpen() && isTableOfJoints(path)) return takeJoints(path);
  actions_->solids->importFile(path);
}

}  // namespace talus
