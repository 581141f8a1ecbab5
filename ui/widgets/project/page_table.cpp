#include "widgets/project/page_table.hpp"

#include <QHeaderView>
#include <QPainter>
#include <algorithm>

#include "document/schema.hpp"
#include "model/stage_length.hpp"
#include "session/current_project.hpp"
#include "session/display.hpp"
#include "session/playback.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/project/joint_rows.hpp"
#include "widgets/project/motion_rows.hpp"

namespace talus {

namespace {

QString number(double value, int figures = 3) { return numbers::significant(value, figures); }
const QString none = QStringLiteral("–");

Item item(Item::Kind kind, size_t index) { return {kind, static_cast<int>(index)}; }

PageRows geometryRows(const Project& project) {
  PageRows content{QObject::tr("Solids"),
                   {QObject::tr("Solid"), QObject::tr("Shape"), QObject::tr("Material"), QObject::tr("Body"),
                    QObject::tr("Mesh size m")},
                   4,
                   {},
                   QObject::tr("The project has no solid.")};
  for (size_t i = 0; i < project.solids.size(); ++i) {
    const Solid& solid = project.solids[i];
    content.rows.push_back({item(Item::Kind::solid, i),
                            {text(solid.name), words::shape(solid.shape), text(solid.material), words::body(solid.body),
                             solid.mesh_size ? number(*solid.mesh_size) : QObject::tr("automatic")}});
  }
  return content;
}

PageRows materialRows(const Project& project) {
  PageRows content{QObject::tr("Materials"),
                   {QObject::tr("Material"), QObject::tr("ρ kg/m³"), QObject::tr("E GPa"), QObject::tr("ν"),
                    QObject::tr("Damping 1/s"), QObject::tr("Law")},
                   1,
                   {},
                   QObject::tr("The project has no material.")};
  for (size_t i = 0; i < project.materials.size(); ++i) {
    const Material& material = project.materials[i];
    content.rows.push_back(
        {item(Item::Kind::material, i),
         {text(material.name), number(material.density, 4), number(material.young / 1e9), number(material.poisson),
          number(material.damping), schema::choiceWords(std::string(to_string(material.law)))}});
  }
  return content;
}

PageRows loadRows(const Project& project) {
  PageRows content{QObject::tr("Loads"),
                   {QObject::tr("What"), QObject::tr("Block"), QObject::tr("At m"), QObject::tr("Value")},
                   3,
                   {},
                   QObject::tr("Nothing but gravity acts."),
                   3};
  for (size_t i = 0; i < project.loads.size(); ++i) {
    const PointLoad& load = project.loads[i];
    content.rows.push_back({item(Item::Kind::load, i),
                            {QObject::tr("force, kN"), text(load.block), words::point(load.at),
                             load.table.empty() ? words::point(load.force / 1e3) : words::span(load.table)}});
  }
  for (size_t i = 0; i < project.constraints.size(); ++i) {
    const Constraint& constraint = project.constraints[i];
    QStringList components;
    for (const auto& component : constraint.displacement)
      components << (component ? number(*component) : QObject::tr("free"));
    content.rows.push_back(
        {item(Item::Kind::constraint, i),
         {QObject::tr("support, m"), text(constraint.block),
          constraint.at ? words::point(*constraint.at) : QObject::tr("whole block"),
          constraint.table.empty() ? components.join(QStringLiteral(", ")) : words::span(constraint.table)}});
  }
  for (size_t i = 0; i < project.velocities.size(); ++i)
    content.rows.push_back({item(Item::Kind::velocity, i),
                            {QObject::tr("velocity, m/s"), text(project.velocities[i].block), none,
                             words::point(project.velocities[i].linear)}});
  for (size_t i = 0; i < project.in_situ.size(); ++i) {
    const InSituStress& stress = project.in_situ[i];
    QStringList names;
    for (const std::string& name : stress.blocks) names << text(name);
    const Voigt mpa = stress.stress / 1e6;
    content.rows.push_back({item(Item::Kind::inSitu, i),
                            {QObject::tr("stress in situ, MPa"),
                             names.isEmpty() ? QObject::tr("every block") : names.join(QStringLiteral(", ")),
                             QObject::tr("z %1").arg(number(stress.level)),
                             words::point(mpa.head<3>()) + QStringLiteral("; ") + words::point(mpa.tail<3>())}});
  }
  for (size_t i = 0; i < project.monitors.size(); ++i) {
    const Monitor& monitor = project.monitors[i];
    content.rows.push_back(
        {item(Item::Kind::monitor, i),
         {QObject::tr("monitor %1").arg(text(monitor.name)), text(monitor.block), words::point(monitor.at),
          monitor.stress ? QObject::tr("motion and stress") : QObject::tr("motion")}});
  }
  return content;
}

PageRows stageRows(const Project& project) {
  PageRows content{QObject::tr("Stages"),
                   {QObject::tr("Stage"), QObject::tr("Type"), QObject::tr("Changes"), QObject::tr("Δt ms"),
                    QObject::tr("Steps"), QObject::tr("Duration s")},
                   3,
                   {},
                   QObject::tr("The project has no stage: there is nothing to solve."),
                   2};
  for (size_t i = 0; i < project.stages.size(); ++i) {
    const Stage& stage = project.stages[i];
    const double duration = length_of(stage);
    const long steps = stage.steps ? *stage.steps : std::lround(duration / stage.time_step);
    content.rows.push_back(
        {item(Item::Kind::stage, i),
         {text(stage.name),
          stage.until_equilibrium ? QObject::tr("static, until equilibrium") : words::stage(stage.kind),
          words::changes(stage), number(stage.time_step * 1e3), numbers::whole(steps), number(duration, 4)}});
  }
  return content;
}

}  // namespace

PageRows rowsOf(WorkflowPage page, const Project& project) {
  switch (page) {
    case WorkflowPage::geometry:
      return geometryRows(project);
    case WorkflowPage::joints:
      return jointRows(project);
    case WorkflowPage::materials:
      return materialRows(project);
    case WorkflowPage::loads:
      return loadRows(project);
    case WorkflowPage::blocks:  // have tables of their own
    case WorkflowPage::mesh:
    case WorkflowPage::stages:
    case WorkflowPage::solve:
    case WorkflowPage::results:
      break;
  }
  return stageRows(project);
}

PageTable::PageTable(CurrentProject& project, Playback& playback, Display& display)
    : project_(project), playback_(playback), display_(display) {
  setAccessibleName(tr("What the project holds of this page"));
  connect(this, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (row >= 0 && row < static_cast<int>(content_.rows.size()))
      project_.selection().select(content_.rows[static_cast<size_t>(row)].item);
  });
  connect(horizontalHeader(), &QHeaderView::sectionClicked, this, &PageTable::sortBy);
  connect(this, &QTableWidget::cellDoubleClicked, this, &PageTable::editCell);
  connect(&display_, &Display::pageChanged, this, [this] { sortedBy_ = -1; });
  connect(&display_, &Display::pageChanged, this, &PageTable::refresh);
  connect(&project_, &CurrentProject::opened, this, &PageTable::refresh);
  connect(&project_, &CurrentProject::systemChanged, this, &PageTable::refresh);
  connect(&project_.document(), &Document::projectChanged, this, &PageTable::refresh);
  connect(&playback_, &Playback::frameChanged, this, [this] {
    if (isVisible() || showsMotion_ != mayShowMotion()) refresh();
  });
  connect(&project_.selection(), &Selection::changed, this, &PageTable::showSelection);
  refresh();
}

bool PageTable::mayShowMotion() const {
  return !isSetUp(display_.page()) && knowsMotions(project_.system().get(), playback_.frame().get());
}

void PageTable::showEvent(QShowEvent* event) {
  if (showsMotion_) refresh();  // of another frame while it was hidden
  PlainTable::showEvent(event);
}

void PageTable::refresh() {
  const QSignalBlocker silent(this);
  showsMotion_ = mayShowMotion();
  content_ = showsMotion_ ? motionRows(*project_.system(), *playback_.frame())
                          : rowsOf(display_.page(), project_.document().project());
  sortRows();
  std::vector<QStringList> rows;
  for (const auto& row : content_.rows) rows.push_back(row.cells);
  std::vector<bool> words(static_cast<size_t>(content_.heads.size()));
  std::fill_n(words.begin(), content_.wordColumns, true);
  setContent(content_.heads, rows, words);
  for (int column = 0; column < columnCount(); ++column) {
    const bool stretches = content_.roomy < 0 || column == content_.roomy;
    horizontalHeader()->setSectionResizeMode(column, stretches ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
  }
  showSelection();
  blockSignals(false);
  emit titleChanged(content_.title);
}

void PageTable::sortBy(int column) {
  if (!content_.sortable) return;
  const bool again = column == sortedBy_;
  if (again && order_ == Qt::DescendingOrder) {
    sortedBy_ = -1;  // a third click: as the project has them
  } else {
    order_ = again ? Qt::DescendingOrder : Qt::AscendingOrder;
    sortedBy_ = column;
  }
  refresh();
}

/// Numbers before words.
void PageTable::sortRows() {
  const bool sorted = content_.sortable && sortedBy_ >= 0 && sortedBy_ < content_.heads.size();
  horizontalHeader()->setSectionsClickable(content_.sortable);
  horizontalHeader()->setSortIndicatorShown(sorted);
  if (!sorted) return;
  horizontalHeader()->setSortIndicator(sortedBy_, order_);
  const auto before = [this](const PageRows::Row& one, const PageRows::Row& two) {
    const QString &a = one.cells[sortedBy_], &b = two.cells[sortedBy_];
    double x = 0, y = 0;
    const bool isNumber = numbers::parse(a, x), isOther = numbers::parse(b, y);
    if (isNumber && isOther) return x < y;
    return isNumber || isOther ? isNumber : a.localeAwareCompare(b) < 0;
  };
  std::ranges::stable_sort(content_.rows, [&](const PageRows::Row& one, const PageRows::Row& two) {
    return order_ == Qt::AscendingOrder ? before(one, two) : before(two, one);
  });
}

void PageTable::editCell(int row, int column) {
  const QString place = content_.rows.at(static_cast<size_t>(row)).places.value(column);
  if (!place.isEmpty()) display_.showField(place);
}

void PageTable::showSelection() {
  const QSignalBlocker silent(this);
  clearSelection();
  const Item& current = project_.selection().current();
  for (size_t row = 0; row < content_.rows.size(); ++row)
    if (content_.rows[row].item == current) {
      setCurrentCell(static_cast<int>(row), 0);
      return;
    }
  setCurrentCell(-1, -1);
}

void PageTable::paintEvent(QPaintEvent* event) {
  QTableWidget::paintEvent(event);
  if (!content_.rows.empty()) return;
  QPainter painter(viewport());
  painter.setPen(theme::colours().textMuted);
  painter.drawText(viewport()->rect(), Qt::AlignCenter, content_.empty);
}

}  // namespace talus
