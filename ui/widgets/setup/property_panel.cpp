#include "widgets/setup/property_panel.hpp"

#include <QApplication>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "base/error.hpp"
#include "document/edits.hpp"
#include "document/item_place.hpp"
#include "document/names.hpp"
#include "document/things.hpp"
#include "mesh/inner_point.hpp"
#include "session/block_edits.hpp"
#include "session/current_project.hpp"
#include "session/display.hpp"
#include "session/messages.hpp"
#include "session/playback.hpp"
#include "widgets/blocks/several_blocks.hpp"
#include "widgets/forms/object_field.hpp"
#include "widgets/forms/scalar_fields.hpp"
#include "widgets/forms/typical_strengths.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/project/motion_rows.hpp"

namespace talus {

PropertyPanel::PropertyPanel(CurrentProject& project, const BlockSurvey& survey, Playback& playback, Messages& messages,
                             Display& display, Picking& picking)
    : project_(project),
      survey_(survey),
      playback_(playback),
      messages_(messages),
      context_{project.document(), {}, &picking, [this] { QTimer::singleShot(0, this, &PropertyPanel::rebuild); }},
      duplicate_(makeTool(QStringLiteral("copy"), tr("Duplicate"))),
      up_(makeTool(QStringLiteral("chevron-up"), tr("Move up the list"))),
      down_(makeTool(QStringLiteral("chevron-down"), tr("Move down the list"))),
      remove_(makeTool(QStringLiteral("close"), tr("Delete"))),
      header_(new PanelHeader(tr("Properties"), {duplicate_, up_, down_, remove_})),
      column_(new QVBoxLayout(this)) {
  setMargins(column_, 0, 0);
  column_->addWidget(header_);
  const auto onClick = [this](QToolButton* button, auto act) {
    connect(button, &QToolButton::clicked, this, [this, act] { tryTo(act); });
  };
  Document& document = project_.document();
  onClick(duplicate_, [this, &document] { things::duplicate(document, project_.selection().current()); });
  onClick(up_, [this, &document] { things::move(document, project_.selection().current(), -1); });
  onClick(down_, [this, &document] { things::move(document, project_.selection().current(), 1); });
  onClick(remove_, [this, &document] { things::remove(document, project_.selection().current()); });
  connect(&project_.selection(), &Selection::changed, this, &PropertyPanel::rebuild);
  connect(&project_, &CurrentProject::opened, this, &PropertyPanel::rebuild);
  connect(&project_, &CurrentProject::systemChanged, this, &PropertyPanel::rebuild);
  // The field that asked for the change still handles its event: it must not be deleted under itself.
  connect(&document, &Document::projectChanged, this, &PropertyPanel::rebuild, Qt::QueuedConnection);
  connect(&display, &Display::unitsChanged, this, &PropertyPanel::rebuild);
  connect(&playback_, &Playback::frameChanged, this, &PropertyPanel::showMotion);
  rebuild();
}

void PropertyPanel::tryTo(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    messages_.add(problemOf(error));
  }
}

Section* PropertyPanel::addSection(const QString& title, const QString& note) {
  auto* layout = static_cast<QVBoxLayout*>(content_->layout());
  if (layout->count() > 0) layout->addWidget(makeLine(Qt::Horizontal));
  auto* section = new Section(title, note);
  layout->addWidget(section);
  return section;
}

void PropertyPanel::rebuild() {
  const Item item = project_.selection().current();
  const QString typedIn = nameOfFieldInUse();
  const int scrolled = scrolled_ && item == shown_ ? scrolled_->verticalScrollBar()->value() : 0;
  shown_ = item;
  delete scrolled_;
  content_ = new QWidget;
  setMargins(new QVBoxLayout(content_), 0, 0);
  scrolled_ = makeScrolled(content_);
  scrolled_->hide();
  column_->addWidget(scrolled_, 1);  // before it is filled: what comes into a window is styled anew with all it holds
  for (auto* tool : {duplicate_, up_, down_, remove_}) tool->setVisible(things::isListed(item.kind));
  context_.blocks.clear();
  if (project_.system())
    for (const auto& block : project_.system()->blocks) context_.blocks.push_back(block.name);
  if (item.kind == Item::Kind::block)
    showBlock(item.index);
  else
    showThing(item);
  static_cast<QVBoxLayout*>(content_->layout())->addStretch();
  scrolled_->show();
  goOnIn(typedIn);
  if (scrolled > 0) {
    content_->layout()->activate();
    scrolled_->verticalScrollBar()->setValue(scrolled);
  }
}

QString PropertyPanel::nameOfFieldInUse() const {
  const auto* field = QApplication::focusWidget();
  return field && isAncestorOf(field) ? field->objectName() : QString();
}

void PropertyPanel::goOnIn(const QString& name) {
  if (name.isEmpty()) return;
  if (auto* field = findChild<QWidget*>(name)) field->setFocus();
}

void PropertyPanel::showThing(const Item& item) {
  if (!project_.document().isOpen()) return;
  const auto& project = project_.document().json();
  const schema::Place place = placeOf(item, project);
  const FieldSite site{context_, place, schema::ruleOf(place)};
  const bool whole = item.kind == Item::Kind::none;
  header_->setTitle(whole ? tr("Project") : site.title(), whole ? tr("nothing is selected") : nameOf(place));
  auto* column = new QWidget(content_);
  auto* rows = new QVBoxLayout(column);
  rows->setContentsMargins(12, 10, 12, 10);
  rows->setSpacing(4);
  if (things::isListed(item.kind) && project.at(place.parent_pointer()).is_object()) {
    auto* row = new QHBoxLayout;
    auto* title = makeLabel(tr("Name"), "muted");
    title->setFixedWidth(title_width);
    row->setSpacing(8);
    row->addWidget(title);
    row->addWidget(new KeyField(site, column), 1);
    rows->addLayout(row);
  }
  if (item.kind == Item::Kind::joint) rows->addWidget(new TypicalStrengths(site, column));
  rows->addWidget(new ObjectField(site, column, whole));
  content_->layout()->addWidget(column);
}

QString PropertyPanel::nameOf(const schema::Place& place) const {
  const auto& project = project_.document().json();
  if (place.parent_pointer().empty()) return {};
  if (project.at(place.parent_pointer()).is_object()) return text(place.back());
  const auto& thing = project.at(place);
  if (thing.contains("name")) return text(thing.at("name").get<std::string>());
  return tr("%1 of %2").arg(std::stoi(place.back()) + 1).arg(project.at(place.parent_pointer()).size());
}

void PropertyPanel::showBody(Section* section, const Block& block) {
  section->addFact(tr("Body"), words::body(block.body));
  if (block.body_reason.empty()) return;
  auto* reason = makeWrappedLabel(tr("chosen: %1").arg(text(block.body_reason)), "muted");
  section->addWide(reason);
}

void PropertyPanel::showBlock(int index) {
  if (!project_.system()) return;
  const BlockSystem& system = *project_.system();
  if (const auto& several = project_.selection().blocks(); several.size() > 1) {
    header_->setTitle(tr("%1 blocks").arg(several.size()), tr("selected"));
    content_->layout()->addWidget(new SeveralBlocks(project_, survey_, messages_, several));
    return;
  }
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
  offerWish(shape, block);
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

void PropertyPanel::offerWish(Section* section, const Block& block) {
  const auto& wishes = project_.document().project().blocks;
  const auto wish = std::ranges::find(wishes, block.name, &BlockOverride::name);
  auto* button = makeButton(wish == wishes.end() ? tr("Name it, or change it…") : tr("Change it…"), "link");
  button->setObjectName(QStringLiteral("wish"));
  button->setToolTip(tr("Name, body, material and mesh size of this block alone"));
  const int index = wish == wishes.end() ? -1 : static_cast<int>(wish - wishes.begin());
  const auto act = [this, index, inside = inner_point(block.mesh), name = block.name] {
    if (index >= 0) return project_.selection().select({Item::Kind::blockWish, index});
    auto changed = project_.document().json();
    const schema::Place place = edits::add(changed, schema::Place("/blocks"));
    edits::set(changed, place / "at", edits::placeJson(inside));
    names::follow(changed, "blocks", {{name, changed.at(place).at("name").get<std::string>()}});
    project_.document().change(changed, tr("name a block"));
    project_.selection().select(itemAt(place, project_.document().json()));
  };
  connect(
      button, &QPushButton::clicked, this, [this, act] { tryTo(act); }, Qt::QueuedConnection);
  auto* excavate = makeButton(tr("Excavate it"), "link");
  excavate->setToolTip(tr("Cuts it and leaves it out; the page Blocks brings it back (Delete)"));
  connect(
      excavate, &QPushButton::clicked, this,
      [this] { tryTo([&] { block_edits::excavate(project_, project_.selection().blocks()); }); }, Qt::QueuedConnection);
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 4, 0, 0);
  for (auto* one : {button, excavate}) line->addWidget(one);
  line->addStretch();
  section->addWide(row);
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

}  // namespace talus
