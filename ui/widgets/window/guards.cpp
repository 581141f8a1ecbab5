#include "widgets/window/guards.hpp"

#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include "base/error.hpp"
#include "session/session.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

/// A name beside the folder that is free: "slide-1.results".
std::filesystem::path freeName(const std::filesystem::path& results) {
  std::error_code unknown;
  for (int number = 1;; ++number) {
    auto name = results.parent_path() / (results.stem().string() + "-" + std::to_string(number));
    name += results.extension();
    if (!std::filesystem::exists(name, unknown)) return name;
  }
}

QString fileName(const std::filesystem::path& path) { return text(path.filename().string()); }

}  // namespace

Guards::Guards(Session& session, QWidget& window, std::function<bool()> saveAs)
    : QObject(&window), session_(session), window_(window), saveAs_(std::move(saveAs)) {}

bool Guards::mayLeaveProject() {
  Document& document = session_.project.document();
  if (!document.isOpen() || document.isSaved()) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                  tr("%1 has changes that are not saved.").arg(document.name()), QMessageBox::NoButton, &window_);
  const auto* save = box.addButton(document.file().empty() ? tr("Save as…") : tr("Save"), QMessageBox::AcceptRole);
  const auto* discard = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
  box.addButton(tr("Cancel"), QMessageBox::RejectRole);
  box.exec();
  if (box.clickedButton() == discard) return true;
  if (box.clickedButton() != save) return false;
  return document.file().empty() ? saveAs_() : session_.project.saveAs(document.file());
}

bool Guards::mayReplaceResults() {
  const auto results = session_.project.document().resultsFolder();
  std::error_code unknown;
  if (!std::filesystem::exists(results / "results.h5", unknown)) return true;
  const QString when = QLocale::c().toString(QFileInfo(text((results / "results.h5").string())).lastModified(),
                                             QStringLiteral("d MMM yyyy, HH:mm"));
  const auto kept = freeName(results);
  QMessageBox box(QMessageBox::Question, tr("Results would be replaced"),
                  tr("%1 holds the results of a run of %2.").arg(fileName(results), when), QMessageBox::NoButton,
                  &window_);
  box.setInformativeText(tr("The new run writes its results in their place."));
  const auto* replace = box.addButton(tr("Replace"), QMessageBox::AcceptRole);
  const auto* keep = box.addButton(tr("Keep as %1").arg(fileName(kept)), QMessageBox::ActionRole);
  box.addButton(tr("Cancel"), QMessageBox::RejectRole);
  box.exec();
  if (box.clickedButton() == replace) return true;
  return box.clickedButton() == keep && keepResultsAs(text(kept.string()));
}

bool Guards::keepResultsAs(const QString& name) {
  const auto results = session_.project.document().resultsFolder();
  if (session_.playback.folder() == results) session_.playback.clear();  // they are read from there
  std::error_code error;
  std::filesystem::rename(results, name.toStdString(), error);
  if (error) {
    session_.messages.add(problemOf(InputError(results.string(), "cannot be renamed: " + error.message(),
                                               "see to the permissions of its folder, or save the project elsewhere")));
    return false;
  }
  session_.messages.log(tr("kept the results of before as %1").arg(name));
  return true;
}

Guards::OfRun Guards::askOfRun() {
  QMessageBox box(QMessageBox::Question, tr("A run goes on"),
                  tr("The run of %1 has come to %2 %.")
                      .arg(session_.project.document().name(), numbers::fixed(100 * session_.run.fraction(), 0)),
                  QMessageBox::NoButton, &window_);
  const QPushButton* leave = nullptr;
  QString consequences = tr("Stopped, it ends after its step, and its results until then stay.");
  if (session_.run.canLeave()) {
    consequences += u'\n' + tr("In the background it goes on without the window, to the same numbers; open the project "
                               "again to see how far it is, or to stop it.");
    leave = box.addButton(tr("Go on in the background"), QMessageBox::AcceptRole);
  }
  box.setInformativeText(consequences);
  const auto* stop = box.addButton(tr("Stop and close"), QMessageBox::DestructiveRole);
  box.setDefaultButton(box.addButton(tr("Stay"), QMessageBox::RejectRole));
  // A run that ends meanwhile needs no answer.
  connect(&session_.run, &CurrentRun::progressed, &box, [&] {
    if (!session_.run.isBusy()) box.accept();
  });
  box.exec();
  if (box.clickedButton() == stop || !session_.run.isBusy()) return OfRun::stop;
  return leave && box.clickedButton() == leave ? OfRun::leave : OfRun::stay;
}

}  // namespace talus
