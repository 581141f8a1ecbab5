#include "widgets/project_tree.hpp"

#include <QHeaderView>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <filesystem>

#include "widgets/numbers.hpp"
#include "widgets/theme.hpp"

namespace talus {

namespace {

constexpr int kind_role = Qt::UserRole, index_role = Qt::UserRole + 1, step_role = Qt::UserRole + 2;

QString text(const std::string& s) { return QString::fromStdString(s); }
QString count(size_t n) { return numbers::whole(static_cast<long long>(n)); }

Item itemOf(const QTreeWidgetItem& row) {
  return {static_cast<Item::Kind>(row.data(0, kind_role).toInt()), row.data(0, index_role).toInt()};
}

QString solidFigure(const Solid& solid) {
  if (std::holds_alternative<BoxShape>(solid.shape)) return QObject::tr("box");
  if (const auto* polyhedron = std::get_if<PolyhedronShape>(&solid.shape))
    return QObject::tr("%1 faces").arg(polyhedron->faces.size());
  return text(std::filesystem::path(std::get<FileShape>(solid.shape).path).extension().string()).mid(1).toUpper();
}

QString stageFigure(const Stage& stage) {
  const double seconds = stage.duration.value_or(stage.steps.value_or(0) * stage.time_step);
  const QString length = numbers::significant(seconds) + QStringLiteral(" s");
  return stage.kind == StageKind::static_ ? QObject::tr("static %1").arg(length) : length;
}

}  // namespace

ProjectTree::ProjectTree(Workspace& workspace) : workspace_(workspace) {
  setHeaderHidden(true);
  setColumnCount(2);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  setUniformRowHeights(true);
  setTextElideMode(Qt::ElideRight);
  setMouseTracking(true);
  setExpandsOnDoubleClick(true);
  setAccessibleName(tr("Project"));
  connect(this, &QTreeWidget::itemEntered, this, [this](QTreeWidgetItem* row) {
    const Item item = itemOf(*row);
    workspace_.selection().hoverBlock(item.kind == Item::Kind::block ? std::optional<int>(item.index) : std::nullopt);
  });
  connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* row) {
    if (!row) return;
    const Item item = itemOf(*row);
    if (item.kind != Item::Kind::none)
      workspace_.selection().select(item);
    else
      workspace_.goTo(static_cast<Step>(row->data(0, step_role).toInt()));
  });
  connect(&workspace_, &Workspace::projectOpened, this, &ProjectTree::rebuild);
  connect(&workspace_, &Workspace::systemChanged, this, &ProjectTree::rebuild);
  connect(&workspace_, &Workspace::themeChanged, this, &ProjectTree::rebuild);  // its colours are in the rows
  connect(&workspace_.document(), &Document::projectChanged, this, &ProjectTree::rebuild);
  connect(&workspace_, &Workspace::stepChanged, this, &ProjectTree::unfoldStep);
  connect(&workspace_.selection(), &Selection::changed, this, &ProjectTree::showSelection);
  rebuild();
}

QTreeWidgetItem* ProjectTree::addGroup(Step step, const QString& figure) {
  auto* group = new QTreeWidgetItem(QStringList{stepTitle(step), figure});
  group->setIcon(0, theme::icon(QLatin1String(stepKey(step))));
  group->setFont(0, theme::font(theme::now().type.body, QFont::Medium));
  group->setForeground(1, theme::colours().textFaint);
  group->setFont(1, theme::font(theme::now().type.small));
  group->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  group->setData(0, kind_role, static_cast<int>(Item::Kind::none));
  group->setData(0, step_role, static_cast<int>(step));
  addTopLevelItem(group);
  groups_[step] = group;
  return group;
}

QTreeWidgetItem* ProjectTree::addRow(QTreeWidgetItem* group, const Item& item, const QString& name,
                                     const QString& figure) {
  auto* row = new QTreeWidgetItem(QStringList{name, figure});
  row->setForeground(1, theme::colours().textFaint);
  row->setFont(1, theme::font(theme::now().type.small));
  row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  row->setData(0, kind_role, static_cast<int>(item.kind));
  row->setData(0, index_role, item.index);
  row->setData(0, step_role, group->data(0, step_role));
  row->setToolTip(0, name);
  group->addChild(row);
  return row;
}

void ProjectTree::rebuild() {
  const QSignalBlocker silent(this);
  std::map<Step, bool> unfolded;
  for (const auto& [step, group] : groups_) unfolded[step] = group->isExpanded();
  clear();
  groups_.clear();
  if (!workspace_.document().isOpen()) return;
  const Project& project = workspace_.document().project();
  const auto& system = workspace_.system();

  auto* geometry = addGroup(Step::geometry, count(project.solids.size()));
  for (size_t i = 0; i < project.solids.size(); ++i)
    addRow(geometry, {Item::Kind::solid, static_cast<int>(i)}, text(project.solids[i].name),
           solidFigure(project.solids[i]));
  addJoints(addGroup(Step::joints, count(project.joints.size())));
  addBlocks(addGroup(Step::blocks, system ? count(system->blocks.size()) : tr("not cut")));
  size_t tetrahedra = 0;
  if (system)
    for (const auto& block : system->blocks) tetrahedra += block.mesh.tetrahedra.size();
  addGroup(Step::mesh, system ? tr("%1 tet").arg(count(tetrahedra)) : tr("not made"));
  auto* materials = addGroup(Step::materials, count(project.materials.size()));
  for (size_t i = 0; i < project.materials.size(); ++i)
    addRow(materials, {Item::Kind::material, static_cast<int>(i)}, text(project.materials[i].name),
           tr("%1 kg/m³").arg(numbers::significant(project.materials[i].density, 4)));
  addLoads(addGroup(Step::loads, count(project.loads.size() + project.constraints.size() + project.velocities.size())));
  auto* stages = addGroup(Step::stages, count(project.stages.size()));
  for (size_t i = 0; i < project.stages.size(); ++i)
    addRow(stages, {Item::Kind::stage, static_cast<int>(i)}, text(project.stages[i].name),
           stageFigure(project.stages[i]));
  auto* results = addGroup(Step::results, {});
  for (size_t i = 0; i < project.monitors.size(); ++i)
    addRow(results, {Item::Kind::monitor, static_cast<int>(i)}, text(project.monitors[i].name),
           tr("on %1").arg(text(project.monitors[i].block)))
        ->setIcon(0, theme::icon(QStringLiteral("monitor")));
  for (const auto& [step, group] : groups_) group->setExpanded(unfolded[step]);
  unfoldStep();
  showSelection();
}

void ProjectTree::addJoints(QTreeWidgetItem* group) {
  const Project& project = workspace_.document().project();
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
}

void ProjectTree::addBlocks(QTreeWidgetItem* group) {
  if (!workspace_.system()) return;
  const auto& blocks = workspace_.system()->blocks;
  for (size_t i = 0; i < blocks.size(); ++i) {
    const bool fixed = blocks[i].body == BodyKind::fixed;
    auto* row = addRow(group, {Item::Kind::block, static_cast<int>(i)}, text(blocks[i].name),
                       fixed ? tr("fixed") : tr("%1 m³").arg(numbers::significant(blocks[i].volume)));
    row->setIcon(0, theme::icon(fixed ? QStringLiteral("fixed") : QStringLiteral("blocks")));
  }
}

void ProjectTree::addLoads(QTreeWidgetItem* group) {
  const Project& project = workspace_.document().project();
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
}

QTreeWidgetItem* ProjectTree::rowOf(const Item& item) const {
  for (const auto& [step, group] : groups_)
    for (int i = 0; i < group->childCount(); ++i)
      if (itemOf(*group->child(i)) == item) return group->child(i);
  return nullptr;
}

void ProjectTree::unfoldStep() {
  const Step step = workspace_.step() == Step::solve ? Step::stages : workspace_.step();
  const auto group = groups_.find(step);
  if (group == groups_.end()) return;
  group->second->setExpanded(true);
  scrollToItem(group->second, QAbstractItemView::EnsureVisible);
}

void ProjectTree::showSelection() {
  const QSignalBlocker silent(this);
  const Item& current = workspace_.selection().current();
  clearSelection();
  setCurrentItem(nullptr);
  QTreeWidgetItem* row = rowOf(current);
  if (!row) return;
  setCurrentItem(row);
  for (int block : workspace_.selection().blocks())
    if (auto* also = rowOf({Item::Kind::block, block})) also->setSelected(true);
  scrollToItem(row);
}

void ProjectTree::mousePressEvent(QMouseEvent* event) {
  auto* row = itemAt(event->pos());
  if (row && event->modifiers().testFlag(Qt::ControlModifier) && itemOf(*row).kind == Item::Kind::block) {
    workspace_.selection().toggleBlock(itemOf(*row).index);
    return;
  }
  QTreeWidget::mousePressEvent(event);
}

void ProjectTree::leaveEvent(QEvent* event) {
  workspace_.selection().hoverBlock(std::nullopt);
  QTreeWidget::leaveEvent(event);
}

}  // namespace talus
