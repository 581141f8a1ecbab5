#include "widgets/actions/load_actions.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "document/edits.hpp"
#include "document/item_place.hpp"
#include "document/names.hpp"
#include "mesh/moments.hpp"
#include "session/session.hpp"
#include "widgets/actions/vector_dialog.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

using schema::Json;
using schema::Place;

namespace {

constexpr double usual_force = 100e3;  // N
constexpr double usual_speed = 1;      // m/s

/// To a millionth of its size.
Json vectorJson(const Vec3& vector) {
  const double grain = vector.isZero() ? 1 : std::pow(10, std::floor(std::log10(vector.norm())) - 6);
  const auto rounded = [&](double component) { return std::round(component / grain) * grain; };
  return {rounded(vector.x()), rounded(vector.y()), rounded(vector.z())};
}

}  // namespace

LoadActions::LoadActions(Session& session, QWidget& window) : QObject(&window), session_(session), window_(window) {
  const QString load = QStringLiteral("loads"), support = QStringLiteral("fixed"), watch = QStringLiteral("monitor");
  loadAtPoint = add(tr("Load at a point…"), load, tr("Click the point where the load acts"),
                    [this](const PickedPlace& picked) { makeLoad(picked); });
  loadOnFace = add(tr("Load on a face…"), load, tr("Click the face that the load acts on"),
                   [this](const PickedPlace& picked) { makeFaceLoad(picked); });
  loadOnBlock = add(tr("Load on a block…"), load, tr("Click the block that the load acts on"),
                    [this](const PickedPlace& picked) { makeBlockLoad(picked); });
  holdPoint = add(tr("Hold a point"), support, tr("Click the point that is to be held"),
                  [this](const PickedPlace& picked) { makeSupports(picked.block, {picked.point}); });
  holdFace = add(tr("Hold a face at its corners"), support, tr("Click the face whose corners are to be held"),
                 [this](const PickedPlace& picked) {
                   const Block& block = session_.project.system()->blocks.at(static_cast<std::size_t>(picked.block));
                   makeSupports(picked.block, face_at(block, picked.point, picked.normal).corners);
                 });
  holdBlock = add(tr("Hold a block"), support, tr("Click the block that is to be held"),
                  [this](const PickedPlace& picked) { holdWhole(picked.block); });
  velocity = new QAction(theme::icon(QStringLiteral("vectors")), tr("Velocity of blocks…"), this);
  connect(velocity, &QAction::triggered, this, [this] {
    const auto& selected = session_.project.selection().blocks();
    if (!selected.empty()) return makeVelocities(selected);
    session_.picking.ask(tr("Click the block that moves at the start"), 1,
                         [this](const std::vector<PickedPlace>& places) { makeVelocities({places.at(0).block}); });
  });
  monitor = add(tr("Monitor here"), watch, tr("Click the point whose history is to be recorded"),
                [this](const PickedPlace& picked) { makeMonitor(picked, false); });
  stressMonitor = add(tr("Monitor with stress here"), watch, tr("Click the point whose stress is to be recorded"),
                      [this](const PickedPlace& picked) { makeMonitor(picked, true); });
}

QAction* LoadActions::add(const QString& words, const QString& icon, const QString& prompt,
                          const std::function<void(const PickedPlace&)>& make) {
  auto* action = new QAction(theme::icon(icon), words, this);
  connect(action, &QAction::triggered, this, [this, prompt, make] {
    session_.picking.ask(prompt, 1, [this, make](const std::vector<PickedPlace>& places) {
      const int blocks = session_.project.system() ? static_cast<int>(session_.project.system()->blocks.size()) : 0;
      if (places.at(0).block >= 0 && places.at(0).block < blocks) make(places.at(0));
    });
  });
  return action;
}

std::vector<QAction*> LoadActions::all() const {
  return {loadAtPoint, loadOnFace, loadOnBlock, holdPoint, holdFace, holdBlock, velocity, monitor, stressMonitor};
}

QString LoadActions::whyNot() const {
  if (!session_.project.document().isOpen()) return tr("Open a project first");
  return session_.project.system() ? QString() : tr("Cut and mesh first: there are no blocks to point at yet");
}

void LoadActions::change(const QString& what, const std::function<Place(Json&)>& edit) {
  Document& document = session_.project.document();
  try {
    Json project = document.json();
    const Place made = edit(project);
    document.change(project, what);
    document.selection().select(itemAt(made, document.json()));
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error));
  }
}

void LoadActions::addThings(const char* list, const std::vector<Json>& things, const QString& what) {
  const Place place = Place() / list;
  change(what, [&](Json& project) {
    if (!project.contains(place)) edits::set(project, place, Json::array());
    for (const Json& thing : things) project[place].push_back(thing);
    return place / (project.at(place).size() - 1);
  });
}

void LoadActions::makeLoad(const PickedPlace& picked) { askForLoad(picked.block, picked.point, std::nullopt); }

void LoadActions::makeFaceLoad(const PickedPlace& picked) {
  const Block& block = session_.project.system()->blocks.at(static_cast<std::size_t>(picked.block));
  const PickedFace face = face_at(block, picked.point, picked.normal);
  if (face.area > 0) askForLoad(picked.block, face.centroid, face);
}

void LoadActions::makeBlockLoad(const PickedPlace& picked) {
  const Block& block = session_.project.system()->blocks.at(static_cast<std::size_t>(picked.block));
  askForLoad(picked.block, volume_moments(block.mesh).centroid, std::nullopt);
}

void LoadActions::askForLoad(int block, const Vec3& at, std::optional<PickedFace> face) {
  const QString name = session_.project.blockName(block);
  auto* dialog = new VectorDialog({.title = tr("New load"),
                                   .about = tr("On block %1, at %2 m").arg(name, words::point(at)),
                                   .kept = QStringLiteral("N"),
                                   .shown = QStringLiteral("kN"),
                                   .preset = usual_force,
                                   .face = std::move(face)},
                                  &window_);
  connect(dialog, &QDialog::accepted, this, [this, dialog, name, at] {
    const Json load{
        {"block", name.toStdString()}, {"at", edits::placeJson(at)}, {"force", vectorJson(dialog->vector())}};
    addThings("loads", std::vector<Json>(1, load), tr("add a load on %1").arg(name));
  });
  dialog->open();
}

void LoadActions::makeSupports(int block, const std::vector<Vec3>& points) {
  const QString name = session_.project.blockName(block);
  std::vector<Json> supports;
  for (const Vec3& point : points)
    supports.push_back(
        Json{{"block", name.toStdString()}, {"at", edits::placeJson(point)}, {"displacement", Json::array({0, 0, 0})}});
  if (supports.empty()) return;
  addThings("constraints", supports,
            supports.size() == 1 ? tr("hold a point of %1").arg(name) : tr("hold a face of %1").arg(name));
}

void LoadActions::holdWhole(int block) {
  const std::string name = session_.project.blockName(block).toStdString();
  const TetMesh& mesh = session_.project.system()->blocks.at(static_cast<std::size_t>(block)).mesh;
  Vec3 inside = Vec3::Zero();
  for (const int node : mesh.tetrahedra.front()) inside += mesh.nodes[static_cast<std::size_t>(node)] / 4;
  change(tr("hold block %1").arg(text(name)), [&](Json& project) {
    for (const char* list : {"blocks", "solids"}) {  // one that has a name, or a solid that is left whole
      const Json none = Json::array();
      const Json& things = project.contains(list) ? project.at(list) : none;
      for (std::size_t i = 0; i < things.size(); ++i) {
        if (things.at(i).at("name") != name) continue;
        const Place place = Place() / list / i;
        edits::set(project, place / "body", "fixed");
        return place;
      }
    }
    const Place place = edits::add(project, Place("/blocks"));
    edits::set(project, place / "at", edits::placeJson(inside));
    edits::set(project, place / "body", "fixed");
    names::follow(project, "blocks", {{name, project.at(place).at("name").get<std::string>()}});
    return place;
  });
}

void LoadActions::makeVelocities(const std::vector<int>& blocks) {
  QStringList names;
  for (const int block : blocks) names << session_.project.blockName(block);
  names.removeAll(QString());
  if (names.isEmpty()) return;
  auto* dialog = new VectorDialog({.title = tr("Initial velocity"),
                                   .about = tr("Of %1").arg(names.join(QStringLiteral(", "))),
                                   .kept = QStringLiteral("m/s"),
                                   .shown = QStringLiteral("m/s"),
                                   .preset = usual_speed},
                                  &window_);
  connect(dialog, &QDialog::accepted, this, [this, dialog, names] {
    std::vector<Json> velocities;
    for (const QString& name : names)
      velocities.push_back(Json{{"block", name.toStdString()}, {"linear", vectorJson(dialog->vector())}});
    addThings(
        "velocities", velocities,
        names.size() == 1 ? tr("give %1 a velocity").arg(names[0]) : tr("give %1 blocks a velocity").arg(names.size()));
  });
  dialog->open();
}

void LoadActions::makeMonitor(const PickedPlace& picked, bool stress) {
  const QString name = session_.project.blockName(picked.block);
  change(tr("add a monitor on %1").arg(name), [&](Json& project) {
    const Place place = edits::add(project, Place("/monitors"));
    edits::set(project, place / "block", name.toStdString());
    edits::set(project, place / "at", edits::placeJson(picked.point));
    if (stress) edits::set(project, place / "stress", true);
    return place;
  });
}

}  // namespace talus
