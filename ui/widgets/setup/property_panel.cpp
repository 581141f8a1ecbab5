#include "widgets/setup/property_panel.hpp"

#include <QApplication>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "session/current_project.hpp"
#include "session/messages.hpp"
#include "session/playback.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/project/motion_rows.hpp"

namespace talus {

PropertyPanel::PropertyPanel(CurrentProject& project, Playback& playback, Messages& messages)
    : project_(project),
      playback_(playback),
      messages_(messages),
      header_(new PanelHeader(tr("Properties"))),
      column_(new QVBoxLayout(this)) {
  setMargins(column_, 0, 0);
  column_->addWidget(header_);
  connect(&project_.selection(), &Selection::changed, this, &PropertyPanel::rebuild);
  connect(&project_, &CurrentProject::opened, this, &PropertyPanel::rebuild);
  connect(&project_, &CurrentProject::systemChanged, this, &PropertyPanel::rebuild);
  // The field that asked for the change still handles its event: it must not be deleted under itself.
  connect(&project_.document(), &Document::projectChanged, this, &PropertyPanel::rebuild, Qt::QueuedConnection);
  connect(&playback_, &Playback::frameChanged, this, &PropertyPanel::showMotion);
  rebuild();
}

Section* PropertyPanel::addSection(const QString& title, const QString& note) {
  auto* layout = static_cast<QVBoxLayout*>(content_->layout());
  if (layout->count() > 0) layout->addWidget(makeLine(Qt::Horizontal));
  auto* section = new Section(title, note);
  layout->addWidget(section);
  return section;
}

void PropertyPanel::rebuild() {
  const QString typedIn = nameOfFieldInUse();
  delete scrolled_;
  content_ = new QWidget;
  setMargins(new QVBoxLayout(content_), 0, 0);
  const Item item = project_.selection().current();
  const Project& project = project_.document().project();
  const auto at = static_cast<size_t>(std::max(0, item.index));
  switch (item.kind) {
    case Item::Kind::none:
      showProject();
      break;
    case Item::Kind::solid:
      showSolid(item.index);
      break;
    case Item::Kind::cut:
      showCut(project.cuts.at(at));
      break;
    case Item::Kind::joint:
      showJoint(item.index);
      break;
    case Item::Kind::block:
      showBlock(item.index);
      break;
    case Item::Kind::material:
      showMaterial(item.index);
      break;
    case Item::Kind::load:
      showLoad(project.loads.at(at));
      break;
    case Item::Kind::constraint:
      showConstraint(project.constraints.at(at));
      break;
    case Item::Kind::velocity:
      showVelocity(project.velocities.at(at));
      break;
    case Item::Kind::stage:
      showStage(project.stages.at(at));
      break;
    case Item::Kind::monitor:
      showMonitor(item.index);
      break;
  }
  static_cast<QVBoxLayout*>(content_->layout())->addStretch();
  scrolled_ = makeScrolled(content_);
  column_->addWidget(scrolled_, 1);
  goOnIn(typedIn);
}

QString PropertyPanel::nameOfFieldInUse() const {
  const auto* field = qobject_cast<NumberField*>(QApplication::focusWidget());
  return field && isAncestorOf(field) ? field->accessibleName() : QString();
}

void PropertyPanel::goOnIn(const QString& name) {
  const auto fields = findChildren<NumberField*>();
  const auto field =
      std::find_if(fields.begin(), fields.end(), [&](const auto* one) { return one->accessibleName() == name; });
  if (!name.isEmpty() && field != fields.end()) (*field)->setFocus();
}

void PropertyPanel::showSolid(int index) {
  const Solid& solid = project_.document().project().solids.at(static_cast<size_t>(index));
  header_->setTitle(text(solid.name), tr("solid"));
  auto* shape = addSection(tr("Shape"));
  if (const auto* box = std::get_if<BoxShape>(&solid.shape)) {
    shape->addFact(tr("From, m"), words::point(box->min));
    shape->addFact(tr("To, m"), words::point(box->max));
  } else if (const auto* polyhedron = std::get_if<PolyhedronShape>(&solid.shape)) {
    shape->addFact(tr("Vertices"), numbers::whole(polyhedron->vertices.size()));
    shape->addFact(tr("Faces"), numbers::whole(polyhedron->faces.size()));
  } else if (const auto* file = std::get_if<FileShape>(&solid.shape)) {
    shape->addFact(tr("File"), text(file->path));
    shape->addFact(tr("Scale"), numbers::significant(file->scale, 6));
  }
  auto* rock = addSection(tr("Rock"));
  rock->addFact(tr("Material"), text(solid.material));
  addBody(rock, index);
  rock->addFact(tr("Mesh size"),
                solid.mesh_size ? tr("%1 m").arg(numbers::significant(*solid.mesh_size)) : tr("automatic"));
}

void PropertyPanel::addBody(Section* section, int solid) {
  static constexpr std::array bodies{BodyKind::automatic, BodyKind::fixed, BodyKind::rigid, BodyKind::affine,
                                     BodyKind::tetrahedra};
  const BodyKind present = project_.document().project().solids.at(static_cast<size_t>(solid)).body;
  QStringList choices;
  for (const BodyKind body : bodies) choices << words::body(body);
  const auto at = std::find(bodies.begin(), bodies.end(), present) - bodies.begin();
  addChoice(section, tr("Body"), tr("How much its blocks may do; the next run cuts and meshes them anew"), choices,
            static_cast<int>(at), [this, solid](int chosen) {
              Solid changed = project_.document().project().solids.at(static_cast<size_t>(solid));
              changed.body = bodies.at(static_cast<size_t>(chosen));
              project_.document().changeSolid(solid, changed);
            });
}

void PropertyPanel::addChoice(Section* section, const QString& name, const QString& tip, const QStringList& words,
                              int present, const std::function<void(int)>& change) {
  auto* box = makeCombo(words, name);
  box->setCurrentIndex(present);
  connect(box, &QComboBox::activated, this, [this, box, present, change](int chosen) {
    if (chosen == present) return;
    try {
      change(chosen);
    } catch (const InputError& error) {
      messages_.add(problemOf(error));
      box->setCurrentIndex(present);
    }
  });
  section->addRow(name, box, tip);
}

void PropertyPanel::showBody(Section* section, const Block& block) {
  section->addFact(tr("Body"), words::body(block.body));
  if (block.body_reason.empty()) return;
  auto* reason = makeWrappedLabel(tr("chosen: %1").arg(text(block.body_reason)), "muted");
  section->addWide(reason);
}

void PropertyPanel::showCut(const Cut& cut) {
  header_->setTitle(tr("Cut"), text(cut.joint));
  auto* orientation = addSection(tr("Orientation"));
  orientation->addFact(tr("Dip"), tr("%1°").arg(numbers::significant(cut.dip, 4)),
                       tr("Steepest inclination of the plane, 0° flat, 90° upright"));
  orientation->addFact(tr("Dip direction"), tr("%1°").arg(numbers::significant(cut.dip_direction, 4)),
                       tr("Azimuth of the steepest line, clockwise from north"));
  auto* position = addSection(tr("Position and extent"));
  position->addFact(tr("Through, m"), words::point(cut.through));
  if (cut.spacing) position->addFact(tr("Spacing"), tr("%1 m").arg(numbers::significant(*cut.spacing)));
  position->addFact(tr("Count"), numbers::whole(cut.count.value_or(1)));
  QStringList names;
  for (const auto& name : cut.solids) names << text(name);
  position->addFact(tr("Divides"), names.isEmpty() ? tr("every solid") : names.join(QStringLiteral(", ")));
}

NumberField* PropertyPanel::addNumber(Section* section, const QString& name, const Quantity& quantity,
                                      std::optional<double> value, const std::function<void(double)>& change) {
  auto* field = new NumberField(value, quantity.scale, quantity.unit);
  field->setAccessibleName(name);
  connect(field, &NumberField::committed, this, [field, change](double typed) {
    try {
      change(typed);
    } catch (const InputError& error) {
      field->setProblem(text(error.problem()) + u'\n' + text(error.remedy()));
    }
  });
  section->addRow(name, field);
  return field;
}

void PropertyPanel::showJoint(int index) {
  const Joint& joint = project_.document().project().joints.at(static_cast<size_t>(index));
  header_->setTitle(text(joint.name), tr("joint"));
  auto* strength = addSection(tr("Strength"), tr("Mohr–Coulomb"));
  const auto give = [this, index](auto Joint::*member, auto value) {
    Joint changed = project_.document().project().joints.at(static_cast<size_t>(index));
    changed.*member = value;
    project_.document().changeJoint(index, changed);
  };
  auto editable = [&](const QString& name, const Quantity& quantity, auto Joint::*member) {
    return addNumber(strength, name, quantity, joint.*member, [=](double value) { give(member, value); });
  };
  editable(tr("Friction angle φ"), {1, QStringLiteral("°")}, &Joint::friction_angle);
  editable(tr("Cohesion c"), {1e6, QStringLiteral("MPa")}, &Joint::cohesion);
  editable(tr("Tension"), {1e6, QStringLiteral("MPa")}, &Joint::tensile_strength);
  if (joint.residual_friction_angle)
    strength->addFact(tr("Residual φ"), tr("%1°").arg(numbers::significant(*joint.residual_friction_angle)));
  NumberField* restitution = editable(tr("Restitution"), {1, QString()}, &Joint::restitution);
  restitution->allowNone(tr("by stiffness"));
  connect(restitution, &NumberField::cleared, this, [=] { give(&Joint::restitution, std::nullopt); });
  auto* stiffness = addSection(tr("Stiffness"));
  auto show = [](const std::optional<double>& value) {
    return value ? numbers::significant(*value / 1e9) + QStringLiteral(" GPa/m") : QObject::tr("automatic");
  };
  stiffness->addFact(tr("Normal"), show(joint.normal_stiffness));
  stiffness->addFact(tr("Shear"), show(joint.shear_stiffness));
}

void PropertyPanel::showBlock(int index) {
  if (!project_.system()) return;
  const BlockSystem& system = *project_.system();
  const Block& block = system.blocks.at(static_cast<size_t>(index));
  header_->setTitle(text(block.name), tr("block"));
  if (block.body != BodyKind::fixed && knowsMotions(project_.system().get(), playback_.frame().get())) {
    motion_ = makeWrappedLabel({});
    addSection(tr("Motion"), tr("at the time in view"))->addWide(motion_);
    showMotion();
  }
  auto* shape = addSection(tr("Shape"), project_.systemIsCurrent() ? QString() : tr("before the last change"));
  shape->addFact(tr("Volume"), tr("%1 m³").arg(numbers::significant(block.volume, 5)));
  showBody(shape, block);
  const auto& materials = project_.document().project().materials;
  if (static_cast<size_t>(block.material) < materials.size()) {
    const Material& material = materials[static_cast<size_t>(block.material)];
    shape->addFact(tr("Material"), text(material.name));
    shape->addFact(tr("Mass"), tr("%1 t").arg(numbers::significant(block.volume * material.density / 1e3)));
  }
  auto* mesh = addSection(tr("Mesh"));
  mesh->addFact(tr("Nodes"), numbers::whole(block.mesh.nodes.size()));
  mesh->addFact(tr("Tetrahedra"), numbers::whole(block.mesh.tetrahedra.size()));
  mesh->addFact(tr("Facets"), numbers::whole(block.surface.size()));
  std::vector<size_t> onJoint(system.joint_names.size());
  for (const auto& triangle : block.surface)
    if (triangle.joint >= 0) ++onJoint[static_cast<size_t>(triangle.joint)];
  auto* joints = addSection(tr("Joints it touches"), tr("facets"));
  for (size_t i = 0; i < onJoint.size(); ++i)
    if (onJoint[i] > 0) joints->addFact(text(system.joint_names[i]), numbers::whole(onJoint[i]));
}

void PropertyPanel::showMotion() {
  const Item item = project_.selection().current();
  const auto frame = playback_.frame();
  const bool known = item.kind == Item::Kind::block && knowsMotions(project_.system().get(), frame.get()) &&
                     project_.system()->blocks[static_cast<size_t>(item.index)].body != BodyKind::fixed;
  if (!motion_) {
    if (known) rebuild();
    return;
  }
  motion_->setText(known ? motionSentence(*project_.system(), frame->motions[static_cast<size_t>(item.index)])
                         : QString());
}

void PropertyPanel::showMaterial(int index) {
  const Material& material = project_.document().project().materials.at(static_cast<size_t>(index));
  header_->setTitle(text(material.name), tr("material"));
  auto* constants = addSection(tr("Constants"), tr("isotropic, elastic"));
  auto editable = [&](const QString& name, const Quantity& quantity, double Material::*member) {
    addNumber(constants, name, quantity, material.*member, [this, index, member](double value) {
      Material changed = project_.document().project().materials.at(static_cast<size_t>(index));
      changed.*member = value;
      project_.document().changeMaterial(index, changed);
    });
  };
  editable(tr("Density ρ"), {1, QStringLiteral("kg/m³")}, &Material::density);
  editable(tr("Young E"), {1e9, QStringLiteral("GPa")}, &Material::young);
  editable(tr("Poisson ν"), {1, {}}, &Material::poisson);
  editable(tr("Damping"), {1, QStringLiteral("1/s")}, &Material::damping);
  static constexpr std::array laws{MaterialLaw::linear, MaterialLaw::neo_hookean};
  addChoice(constants, tr("Law"), tr("neo-hookean stiffens under compression: for strains of more than a few percent"),
            {text(to_string(laws[0])), text(to_string(laws[1]))}, material.law == laws[0] ? 0 : 1,
            [this, index](int chosen) {
              Material changed = project_.document().project().materials.at(static_cast<size_t>(index));
              changed.law = laws.at(static_cast<size_t>(chosen));
              project_.document().changeMaterial(index, changed);
            });
}

void PropertyPanel::showMonitor(int index) {
  const Monitor& monitor = project_.document().project().monitors.at(static_cast<size_t>(index));
  header_->setTitle(text(monitor.name), tr("monitor"));
  auto* section = addSection(tr("Place"));
  section->addFact(tr("Block"), text(monitor.block));
  section->addFact(tr("At, m"), words::point(monitor.at));
  section->addFact(tr("Stress"), monitor.stress ? tr("recorded") : tr("not recorded"));
}

}  // namespace talus
