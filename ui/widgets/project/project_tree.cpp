#include "widgets/project/project_tree.hpp"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "document/item_place.hpp"
#include "document/schema.hpp"
#include "document/things.hpp"
#include "model/stage_length.hpp"
#include "session/current_project.hpp"
#include "session/display.hpp"
#include "session/messages.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/project/tree_rows.hpp"

namespace talus {

namespace {

constexpr size_t most_blocks = 200;  // that the tree lists: more are found in their table
const std::vector<std::pair<WorkflowPage, std::vector<Item::Kind>>> offered_new{
    {WorkflowPage::geometry, {Item::Kind::solid}},
    {WorkflowPage::joints, {Item::Kind::joint, Item::Kind::cut, Item::Kind::interface}},
    {WorkflowPage::blocks, {Item::Kind::blockWish, Item::Kind::merge}},
    {WorkflowPage::materials, {Item::Kind::material}},
    {WorkflowPage::loads, {Item::Kind::load, Item::Kind::constraint, Item::Kind::velocity, Item::Kind::inSitu}},
    {WorkflowPage::stages, {Item::Kind::stage}},
    {WorkflowPage::results, {Item::Kind::monitor, Item::Kind::expectation}}};
constexpr int kind_role = Qt::UserRole, index_role = Qt::UserRole + 1, page_role = Qt::UserRole + 2;

Item itemOf(const QTreeWidgetItem& row) {
  return {static_cast<Item::Kind>(row.data(0, kind_role).toInt()), row.data(0, index_role).toInt()};
}

QString solidFigure(const Solid& solid) {
  if (const auto* polyhedron = std::get_if<PolyhedronShape>(&solid.shape))
    return QObject::tr("%1 faces").arg(polyhedron->faces.size());
  if (const auto* file = std::get_if<FileShape>(&solid.shape))
    return text(std::filesystem::path(file->path).extension().string()).mid(1).toUpper();
  if (std::holds_alternative<TerrainShape>(solid.shape)) return QObject::tr("terrain");  // its file is in the table
  return words::shape(solid.shape);
}

QString stageFigure(const Stage& stage) {
  const double seconds = length_of(stage);
  const QString length = numbers::significant(seconds) + QStringLiteral(" s");
  return stage.kind == StageKind::static_ ? QObject::tr("static %1").arg(length) : length;
}

/// A click on the button shows the menu.
void showMenuOf(QToolButton& button, QMenu* menu) {
  button.setMenu(menu);
  button.setPopupMode(QToolButton::InstantPopup);
  button.setProperty("kind", "new");
}

}  // namespace

ProjectTree::ProjectTree(CurrentProject& project, Display& display, Messages& messages)
    : project_(project), display_(display), messages_(messages) {
  setHeaderHidden(true);
  setColumnCount(3);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  setColumnHidden(TreeRows::figure_column, true);
  setItemDelegateForColumn(0, new TreeRows(this));
  header()->setSectionResizeMode(2, QHeaderView::Fixed);
  header()->setMinimumSectionSize(0);
  header()->resizeSection(2, theme::now().metrics.row);
  setUniformRowHeights(true);
  setTextElideMode(Qt::ElideRight);
  setMouseTracking(true);
  setExpandsOnDoubleClick(true);
  setAccessibleName(tr("Project"));
  connect(this, &QTreeWidget::itemEntered, this,
          [this](QTreeWidgetItem* row) { project_.selection().hover(itemOf(*row)); });
  connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* row) {
    if (!row) return;
    const Item item = itemOf(*row);
    if (item.kind != Item::Kind::none)
      project_.selection().select(item);
    else
      display_.goTo(static_cast<WorkflowPage>(row->data(0, page_role).toInt()));
  });
  connect(&project_, &CurrentProject::opened, this, &ProjectTree::rebuild);
  connect(&project_, &CurrentProject::systemChanged, this, &ProjectTree::rebuild);
  connect(&display_, &Display::themeChanged, this, &ProjectTree::rebuild);  // its colours are in the rows
  connect(&project_.document(), &Document::projectChanged, this, &ProjectTree::rebuild);
  connect(&display_, &Display::pageChanged, this, &ProjectTree::unfoldPage);
  connect(&project_.selection(), &Selection::changed, this, &ProjectTree::showSelection);
  rebuild();
}

QTreeWidgetItem* ProjectTree::addGroup(WorkflowPage page, const QString& figure) {
  auto* group = new QTreeWidgetItem(QStringList{pageTitle(page), figure});
  group->setIcon(0, theme::icon(QLatin1String(pageKey(page))));
  group->setFont(0, theme::font(theme::now().type.body, QFont::Medium));
  group->setForeground(1, theme::colours().textFaint);
  group->setFont(1, theme::font(theme::now().type.small));
  group->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  group->setData(0, kind_role, static_cast<int>(Item::Kind::none));
  group->setData(0, page_role, static_cast<int>(page));
  groups_[page] = group;
  return group;
}

void ProjectTree::offerNew(WorkflowPage page, const std::vector<Item::Kind>& kinds) {
  auto* button =
      makeTool(QStringLiteral("plus"),
               kinds.size() == 1 ? tr("New %1").arg(schema::withinSentence(things::titleOf(kinds[0]))) : tr("New…"));
  button->setObjectName(QStringLiteral("new/") + QLatin1String(pageKey(page)));
  const auto add = [this](Item::Kind kind) {
    try {
      things::add(project_.document(), kind);
    } catch (const InputError& error) {
      messages_.add(problemOf(error));
    }
  };
  const auto menu = newMenus_.find(page);
  // The tree is made anew by what is added, and the button with it: after the click.
  if (menu != newMenus_.end()) {
    showMenuOf(*button, menu->second);
  } else if (kinds.size() == 1) {
    connect(
        button, &QToolButton::clicked, this, [add, kind = kinds[0]] { add(kind); }, Qt::QueuedConnection);
  } else {
    auto* choices = new QMenu(tr("New"), button);
    for (const auto kind : kinds)
      connect(
          choices->addAction(things::titleOf(kind)), &QAction::triggered, this, [add, kind] { add(kind); },
          Qt::QueuedConnection);
    showMenuOf(*button, choices);
  }
  setItemWidget(groups_.at(page), 2, button);
}

bool ProjectTree::focusNew(const QString& list) {
  for (const auto& [page, kinds] : offered_new) {
    const bool makesOne = std::ranges::any_of(kinds, [&](Item::Kind kind) {
      const char* key = listKey(kind);
      return key && list == QLatin1String(key);
    });
    auto* button = findChild<QToolButton*>(QStringLiteral("new/") + QLatin1String(pageKey(page)));
    if (!makesOne || !button) continue;
    scrollToItem(groups_.at(page));
    button->setFocus(Qt::ShortcutFocusReason);
    return true;
  }
  return false;
}

QTreeWidgetItem* ProjectTree::addRow(QTreeWidgetItem* group, const Item& item, const QString& name,
                                     const QString& figure) {
  auto* row = new QTreeWidgetItem(QStringList{name, figure});
  row->setForeground(1, theme::colours().textFaint);
  row->setFont(1, theme::font(theme::now().type.small));
  row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  row->setData(0, kind_role, static_cast<int>(item.kind));
  row->setData(0, index_role, item.index);
  row->setData(0, page_role, group->data(0, page_role));
  row->setToolTip(0, name);
  group->addChild(row);
  return row;
}

void ProjectTree::rebuild() {
  const QSignalBlocker silent(this);
  std::map<WorkflowPage, bool> unfolded;
  for (const auto& [page, group] : groups_) unfolded[page] = group->isExpanded();
  clear();
  groups_.clear();
  blockRows_.clear();
  if (!project_.document().isOpen()) return;
  const Project& project = project_.document().project();
  const auto& system = project_.system();

  auto* geometry = addGroup(WorkflowPage::geometry, numbers::whole(project.solids.size()));
  for (size_t i = 0; i < project.solids.size(); ++i)
    addRow(geometry, {Item::Kind::solid, static_cast<int>(i)}, text(project.solids[i].name),
           solidFigure(project.solids[i]));
  addJoints(addGroup(WorkflowPage::joints, numbers::whole(project.joints.size())));
  const bool current = project_.systemIsCurrent();
  addBlocks(addGroup(WorkflowPage::blocks, !system   ? tr("not cut")
                                           : current ? numbers::whole(system->blocks.size())
                                                     : tr("outdated")));
  size_t tetrahedra = 0;
  if (system)
    for (const auto& block : system->blocks) tetrahedra += block.mesh.tetrahedra.size();
  auto* mesh = addGroup(WorkflowPage::mesh, !system   ? tr("not made")
                                            : current ? tr("%1 tet").arg(numbers::whole(tetrahedra))
                                                      : tr("outdated"));
  addRow(mesh, {Item::Kind::mesh, 0}, tr("mesh sizes"),
         project.mesh.size ? tr("%1 m").arg(numbers::significant(*project.mesh.size)) : tr("by solid"))
      ->setIcon(0, theme::icon(QStringLiteral("settings")));
  auto* materials = addGroup(WorkflowPage::materials, numbers::whole(project.materials.size()));
  for (size_t i = 0; i < project.materials.size(); ++i)
    addRow(materials, {Item::Kind::material, static_cast<int>(i)}, text(project.materials[i].name),
           tr("%1 kg/m³").arg(numbers::significant(project.materials[i].density, 4)));
  addLoads(addGroup(WorkflowPage::loads, numbers::whole(project.loads.size() + project.constraints.size() +
                                                        project.velocities.size() + project.in_situ.size())));
  auto* stages = addGroup(WorkflowPage::stages, numbers::whole(project.stages.size()));
  for (size_t i = 0; i < project.stages.size(); ++i)
    addRow(stages, {Item::Kind::stage, static_cast<int>(i)}, text(project.stages[i].name),
           stageFigure(project.stages[i]));
  addRow(stages, {Item::Kind::solver, 0}, tr("solver"),
         schema::choiceWords(std::string(to_string(project.solver.time_step_control))))
      ->setIcon(0, theme::icon(QStringLiteral("settings")));
  addRow(stages, {Item::Kind::output, 0}, tr("output"),
         tr("every %1 s").arg(numbers::significant(project.output.every)))
      ->setIcon(0, theme::icon(QStringLiteral("film")));
  auto* results = addGroup(WorkflowPage::results, {});
  for (size_t i = 0; i < project.monitors.size(); ++i)
    addRow(results, {Item::Kind::monitor, static_cast<int>(i)}, text(project.monitors[i].name),
           tr("on %1").arg(text(project.monitors[i].block)))
        ->setIcon(0, theme::icon(QStringLiteral("monitor")));
  for (size_t i = 0; i < project.expect.size(); ++i)
    addRow(results, {Item::Kind::expectation, static_cast<int>(i)}, text(project.expect[i].quantity),
           numbers::significant(project.expect[i].value))
        ->setIcon(0, theme::icon(QStringLiteral("check")));
  // Groups come with their rows: each row that came into a tree which is seen would be laid out.
  for (const auto& [page, group] : groups_) addTopLevelItem(group);
  for (const auto& [page, kinds] : offered_new) offerNew(page, kinds);
  for (const auto& [page, group] : groups_) group->setExpanded(unfolded[page]);
  unfoldPage();
  showSelection();
}

void ProjectTree::addJoints(QTreeWidgetItem* group) {
  const Project& project = project_.document().project();
  for (size_t i = 0; i < project.joints.size(); ++i) {
    const Joint& joint = project.joints[i];
    auto* row = addRow(group, {Item::Kind::joint, static_cast<int>(i)}, text(joint.name),
                       tr("φ %1°").arg(numbers::significant(joint.friction_angle)));
    row->setIcon(0, theme::swatch(theme::seriesColour(static_cast<int>(i))));
  }
  for (size_t i = 0; i < project.cuts.size(); ++i) {
    const Cut& cut = project.cuts[i];
    auto* row = addRow(group, {Item::Kind::cut, static_cast<int>(i)}, tr("cut %1, %2").arg(i + 1).arg(text(cut.joint)),
                       numbers::orientation(cut.dip, cut.dip_direction));
    row->setIcon(0, theme::icon(QStringLiteral("cut")));
  }
  for (size_t i = 0; i < project.interfaces.size(); ++i) {
    const Interface& interface = project.interfaces[i];
    addRow(group, {Item::Kind::interface, static_cast<int>(i)},
           tr("%1 – %2").arg(text(interface.between[0]), text(interface.between[1])), text(interface.joint))
        ->setIcon(0, theme::icon(QStringLiteral("face")));
  }
}

void ProjectTree::addBlocks(QTreeWidgetItem* group) {
  const auto& wishes = project_.document().project().blocks;
  const auto leadToTable = [&](size_t count) {
    if (count > most_blocks)
      addRow(group, {Item::Kind::none, 0}, tr("%1 more in the table").arg(count - most_blocks), {})
          ->setIcon(0, theme::icon(QStringLiteral("table")));
  };
  for (size_t i = 0; i < std::min(wishes.size(), most_blocks); ++i)
    addRow(group, {Item::Kind::blockWish, static_cast<int>(i)}, text(wishes[i].name), tr("named"))
        ->setIcon(0, theme::icon(QStringLiteral("point")));
  leadToTable(wishes.size());
  const auto& merges = project_.document().project().merges;
  for (size_t i = 0; i < merges.size(); ++i)
    addRow(group, {Item::Kind::merge, static_cast<int>(i)}, tr("merge %1").arg(i + 1), words::point(merges[i].at, 3))
        ->setIcon(0, theme::icon(QStringLiteral("plus-set")));
  const Splinters& splinters = project_.document().project().splinters;
  addRow(group, {Item::Kind::splinters, 0}, tr("splinters"),
         schema::choiceWords(std::string(to_string(splinters.rule))))
      ->setIcon(0, theme::icon(QStringLiteral("settings")));
  if (!project_.system()) return;
  const auto& blocks = project_.system()->blocks;
  for (size_t i = 0; i < std::min(blocks.size(), most_blocks); ++i) {
    const bool fixed = blocks[i].body == BodyKind::fixed;
    auto* row = addRow(group, {Item::Kind::block, static_cast<int>(i)}, text(blocks[i].name),
                       fixed ? tr("fixed") : tr("%1 m³").arg(numbers::significant(blocks[i].volume)));
    row->setIcon(0, theme::icon(fixed ? QStringLiteral("fixed") : QStringLiteral("blocks")));
    blockRows_.push_back(row);
  }
  leadToTable(blocks.size());
}

void ProjectTree::addLoads(QTreeWidgetItem* group) {
  const Project& project = project_.document().project();
  for (size_t i = 0; i < project.loads.size(); ++i) {
    const PointLoad& load = project.loads[i];
    addRow(group, {Item::Kind::load, static_cast<int>(i)}, tr("load on %1").arg(text(load.block)),
           load.table.empty() ? tr("%1 kN").arg(numbers::significant(load.force.norm() / 1e3)) : tr("by table"));
  }
  for (size_t i = 0; i < project.constraints.size(); ++i)
    addRow(group, {Item::Kind::constraint, static_cast<int>(i)},
           tr("support of %1").arg(text(project.constraints[i].block)), {});
  for (size_t i = 0; i < project.velocities.size(); ++i)
    addRow(group, {Item::Kind::velocity, static_cast<int>(i)},
           tr("velocity of %1").arg(text(project.velocities[i].block)),
           tr("%1 m/s").arg(numbers::significant(project.velocities[i].linear.norm())));
  for (size_t i = 0; i < project.in_situ.size(); ++i)
    addRow(group, {Item::Kind::inSitu, static_cast<int>(i)}, tr("stress in situ %1").arg(i + 1),
           project.in_situ[i].blocks.empty() ? tr("every block")
                                             : numbers::counted(project.in_situ[i].blocks.size(), "block"));
}

QTreeWidgetItem* ProjectTree::rowOf(const Item& item) const {
  for (const auto& [page, group] : groups_)
    for (int i = 0; i < group->childCount(); ++i)
      if (itemOf(*group->child(i)) == item) return group->child(i);
  return nullptr;
}

void ProjectTree::unfoldPage() {
  const WorkflowPage page = display_.page() == WorkflowPage::solve ? WorkflowPage::stages : display_.page();
  const auto group = groups_.find(page);
  if (group == groups_.end()) return;
  group->second->setExpanded(true);
  scrollToItem(group->second, QAbstractItemView::EnsureVisible);
}

void ProjectTree::showSelection() {
  const QSignalBlocker silent(this);
  const Item& current = project_.selection().current();
  clearSelection();
  setCurrentItem(nullptr);
  QTreeWidgetItem* row = rowOf(current);
  if (!row) return;
  setCurrentItem(row);
  for (const int block : project_.selection().blocks())
    if (block < static_cast<int>(blockRows_.size())) blockRows_[static_cast<size_t>(block)]->setSelected(true);
  for (const int solid : project_.selection().solids())
    if (auto* also = rowOf({Item::Kind::solid, solid})) also->setSelected(true);
  scrollToItem(row);
}

void ProjectTree::mousePressEvent(QMouseEvent* event) {
  auto* row = itemAt(event->pos());
  if (row && event->modifiers().testFlag(Qt::ControlModifier)) {
    const Item item = itemOf(*row);
    if (item.kind == Item::Kind::block) return project_.selection().toggleBlock(item.index);
    if (item.kind == Item::Kind::solid) return project_.selection().toggleSolid(item.index);
  }
  QTreeWidget::mousePressEvent(event);
}

void ProjectTree::contextMenuEvent(QContextMenuEvent* event) {
  const auto* row = itemAt(event->pos());
  if (!row || itemOf(*row).kind == Item::Kind::none) return;
  emit menuWanted(event->globalPos());
}

void ProjectTree::setNewMenu(WorkflowPage page, QMenu* menu) {
  newMenus_[page] = menu;
  rebuild();
}

void ProjectTree::leaveEvent(QEvent* event) {
  project_.selection().hover();
  QTreeWidget::leaveEvent(event);
}

}  // namespace talus
