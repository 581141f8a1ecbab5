#include "widgets/geometry/solid_tools.hpp"

#include <QAction>
#include <QFileDialog>
#include <QMenu>
#include <QWidget>
#include <algorithm>

#include "base/error.hpp"
#include "geometry/solid_surface.hpp"
#include "model/solid_moves.hpp"
#include "session/session.hpp"
#include "widgets/geometry/import_dialog.hpp"
#include "widgets/geometry/measure_card.hpp"
#include "widgets/geometry/section_editor.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

SolidTools::SolidTools(Session& session, QWidget& window) : QObject(&window), session_(session), window_(window) {
  makeActions();
  connect(&session_.project, &CurrentProject::opened, this, &SolidTools::refresh);
  connect(&session_.surfaces, &SolidSurfaces::changed, this, &SolidTools::refresh);
  connect(&session_.project, &CurrentProject::systemChanged, this, &SolidTools::refresh);
  connect(&session_.project.document(), &Document::projectChanged, this, &SolidTools::refresh);
  connect(&session_.project.selection(), &Selection::changed, this, &SolidTools::refresh);
  refresh();
}

QAction* SolidTools::add(const QString& text, const char* icon, const QString& shortcut,
                         const std::function<void()>& act) {
  auto* action = new QAction(theme::icon(QLatin1String(icon)), text, this);
  action->setShortcut(QKeySequence(shortcut));
  connect(action, &QAction::triggered, this, act);
  all_.push_back(action);
  return action;
}

void SolidTools::makeActions() {
  using Kind = MoveDialog::Kind;
  importGeometry = add(tr("Import geometry…"), "import", tr("Ctrl+Shift+I"), [this] { askForFile(); });
  newBox = add(tr("New box"), "blocks", {}, [this] { makeNew(NewShape::box, tr("add a box")); });
  newBench = add(tr("New bench in section"), "section", {}, [this] {
    makeNew(NewShape::bench, tr("add a bench"));
    openSection();
  });
  newPolyhedron =
      add(tr("New polyhedron"), "geometry", {}, [this] { makeNew(NewShape::polyhedron, tr("add a polyhedron")); });
  newTunnel = add(tr("New tunnel"), "scatter", {}, [this] { makeNew(NewShape::tunnel, tr("add a tunnel")); });
  section = add(tr("Edit section…"), "section", {}, [this] { openSection(); });
  move = add(tr("Move solids…"), "vectors", {}, [this] { openMove(Kind::move); });
  turn = add(tr("Turn solids…"), "redo", {}, [this] { openMove(Kind::turn); });
  scale = add(tr("Scale solids…"), "fit", {}, [this] { openMove(Kind::scale); });
  copy = add(tr("Copy solids…"), "copy", {}, [this] { openMove(Kind::copy); });
  unite = add(tr("Unite solids"), "plus-set", {}, [this] { combine(CombineOperation::unite, tr("unite solids")); });
  subtract = add(tr("Subtract the last selected"), "dash", {},
                 [this] { combine(CombineOperation::subtract, tr("subtract solids")); });
  intersect = add(tr("Intersect solids"), "filter", {},
                  [this] { combine(CombineOperation::intersect, tr("intersect solids")); });
  measure = add(tr("Measure"), "measure", tr("D"), [this] { openMeasure(); });
}

void SolidTools::addNew(QMenu& menu) const {
  menu.addActions({newBox, newBench, newPolyhedron, newTunnel, importGeometry});
}

void SolidTools::addChanges(QMenu& menu) const {
  menu.addActions({section, move, turn, scale, copy});
  menu.addSeparator();
  menu.addActions({unite, subtract, intersect});
}

void SolidTools::refresh() {
  const Document& document = session_.project.document();
  const auto& chosen = session_.project.selection().solids();
  const QString noProject = document.isOpen() ? QString() : tr("Open a project first");
  allow(*importGeometry, {});
  for (auto* action : {newBox, newBench, newPolyhedron, newTunnel}) allow(*action, noProject);
  const QString noSolid = chosen.empty() ? tr("Select a solid first") : QString();
  for (auto* action : {move, turn, scale, copy}) allow(*action, noSolid);
  const QString tooFew = chosen.size() < 2 ? tr("Select two solids or more: Ctrl and a click adds one") : QString();
  for (auto* action : {unite, subtract, intersect}) allow(*action, tooFew);
  const auto hasSection = [&](int solid) {
    return std::holds_alternative<SectionShape>(document.project().solids.at(static_cast<std::size_t>(solid)).shape);
  };
  const bool isSection = chosen.size() == 1 && hasSection(chosen[0]);
  allow(*section, isSection ? QString() : tr("Select a solid that is made of a section first"));
  const bool isSeen = session_.surfaces.current() || session_.project.system();
  allow(*measure, isSeen ? QString() : tr("There is no rock yet"));
}

void SolidTools::askForFile() {
  const QString name = QFileDialog::getOpenFileName(
      &window_, tr("Import geometry"), text(session_.project.document().folder().string()),
      tr("Geometry (*.step *.stp *.iges *.igs *.brep *.stl *.obj *.ply *.msh *.asc *.tif *.tiff *.xyz *.csv *.txt);;"
         "Solids (*.step *.stp *.iges *.igs *.brep *.stl *.obj *.ply *.msh);;"
         "Terrain (*.asc *.tif *.tiff *.xyz *.csv *.txt *.stl *.obj *.ply);;All files (*)"));
  if (!name.isEmpty()) importFile(name.toStdString());
}

void SolidTools::importFile(const std::filesystem::path& file) {
  if (!session_.project.document().isOpen()) emit projectWanted(file);
  if (!session_.project.document().isOpen()) return;
  session_.display.goTo(WorkflowPage::geometry);
  auto* dialog = new ImportDialog(session_.project, file, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void SolidTools::makeNew(NewShape shape, const QString& what) {
  Document& document = session_.project.document();
  try {
    document.change(with_new_solid(document.project(), shape, session_.surfaces.extent()), what);
    session_.display.goTo(WorkflowPage::geometry);
    session_.project.selection().select({Item::Kind::solid, static_cast<int>(document.project().solids.size()) - 1});
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error));
  }
}

void SolidTools::combine(CombineOperation operation, const QString& what) {
  Document& document = session_.project.document();
  std::vector<int> solids = session_.project.selection().solids();
  // The one that was selected last comes last: it is what is subtracted.
  const auto last = std::ranges::find(solids, session_.project.selection().current().index);
  if (last != solids.end()) std::rotate(last, last + 1, solids.end());
  try {
    document.change(with_combined(document.project(), operation, solids), what);
    session_.project.selection().select({Item::Kind::solid, static_cast<int>(document.project().solids.size()) - 1});
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error));
  }
}

void SolidTools::openSection() {
  if (!editor_) editor_ = new SectionEditor(session_.project, &window_);
  editor_->present();
}

void SolidTools::openMove(MoveDialog::Kind kind) {
  session_.display.goTo(WorkflowPage::geometry);
  auto* dialog =
      new MoveDialog(session_.project, session_.surfaces, kind, session_.project.selection().solids(), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

void SolidTools::openMeasure() {
  if (!measureCard_) measureCard_ = new MeasureCard(session_.project.document(), session_.picking, view_);
  measureCard_->begin();
}

}  // namespace talus
