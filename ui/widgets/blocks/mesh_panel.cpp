#include "widgets/blocks/mesh_panel.hpp"

#include <QComboBox>
#include <QHeaderView>

#include "session/block_survey.hpp"
#include "session/display.hpp"
#include "widgets/blocks/block_columns.hpp"
#include "widgets/blocks/block_table.hpp"
#include "widgets/blocks/quality_chart.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int chart_width = 250, worst_width = 240;
/// Below these a tetrahedron is stiff, and a step of it small: limits that meshers commonly warn at.
constexpr double poor_ratio = 0.2, poor_angle = 10;
constexpr double surroundings = 3;  // what the view shows round a tetrahedron, over its edges

/// The longest edge [m].
double sizeOf(const BlockSystem& system, const PoorTetrahedron& one) {
  const TetMesh& mesh = system.blocks[static_cast<std::size_t>(one.block)].mesh;
  const auto& nodes = mesh.tetrahedra[static_cast<std::size_t>(one.tetrahedron)];
  double longest = 0;
  for (const int a : nodes)
    for (const int b : nodes) longest = std::max(longest, (mesh.nodes[a] - mesh.nodes[b]).norm());
  return longest;
}

}  // namespace

MeshPanel::MeshPanel(CurrentProject& project, BlockSurvey& survey, Display& display)
    : project_(project), survey_(survey), display_(display), table_(new BlockTable(project)) {
  auto* row = new QHBoxLayout(this);
  setMargins(row, 0, 0);
  table_->setObjectName(QStringLiteral("mesh"));
  table_->setAccessibleName(tr("Mesh of each block"));
  row->addWidget(table_, 1);
  row->addWidget(makeLine(Qt::Vertical));
  row->addWidget(makeChart());
  row->addWidget(makeLine(Qt::Vertical));
  row->addWidget(makeWorst());
  connect(&survey_, &BlockSurvey::changed, this, &MeshPanel::refresh);
  connect(&project_.document(), &Document::projectChanged, this, [this] { emit titleChanged(title()); });
  refresh();
}

QWidget* MeshPanel::makeChart() {
  auto* plane = makePlane("surface");
  plane->setFixedWidth(chart_width);
  auto* column = new QVBoxLayout(plane);
  column->setContentsMargins(12, 6, 12, 6);
  column->setSpacing(4);
  measure_ = makeCombo({tr("Radius ratio"), tr("Smallest angle")}, tr("Measure of quality"));
  measure_->setObjectName(QStringLiteral("measure"));
  measure_->setToolTip(
      tr("3 × inscribed over circumscribed radius: 1 of a regular tetrahedron, 0 of a flat one; or the smallest angle "
         "between two of its faces: 70.5° of a regular one"));
  column->addWidget(measure_);
  chart_ = new QualityChart;
  column->addWidget(chart_, 1);
  connect(measure_, &QComboBox::activated, this, &MeshPanel::showChart);
  return plane;
}

QWidget* MeshPanel::makeWorst() {
  worst_ = new PlainTable;
  worst_->setObjectName(QStringLiteral("worst"));
  worst_->setAccessibleName(tr("The worst tetrahedra"));
  worst_->setFixedWidth(worst_width);
  worst_->setToolTip(tr("A click lets the view go there"));
  connect(worst_, &QTableWidget::currentCellChanged, this, [this](int row) { goTo(row); });
  connect(worst_, &QTableWidget::cellClicked, this, [this](int row) { goTo(row); });
  return worst_;
}

QString MeshPanel::title() const {
  return project_.system() && !project_.systemIsCurrent() ? tr("Mesh, before the last change") : tr("Mesh");
}

void MeshPanel::showEvent(QShowEvent* event) {
  survey_.want();
  refresh();
  QWidget::showEvent(event);
}

void MeshPanel::hideEvent(QHideEvent* event) {
  display_.mark({});
  QWidget::hideEvent(event);
}

void MeshPanel::refresh() {
  emit titleChanged(title());
  if (!isVisible()) return;
  table_->setEmptyWords(tr("Not meshed yet."));
  std::vector<BlockColumn> columns;
  if (project_.system()) columns = meshColumns(project_.system(), survey_.mesh());
  table_->setContent(std::move(columns));
  showChart();
  showWorst();
}

void MeshPanel::showChart() {
  if (!survey_.mesh()) return chart_->clear();
  if (measure_->currentIndex() == 0)
    chart_->show(survey_.mesh()->quality, poor_ratio, 1, {});
  else
    chart_->show(survey_.mesh()->dihedral, poor_angle, 0, QStringLiteral("°"));
}

void MeshPanel::showWorst() {
  std::vector<QStringList> rows;
  if (survey_.mesh())
    for (const PoorTetrahedron& one : survey_.mesh()->worst)
      rows.push_back(
          {project_.blockName(one.block), numbers::fixed(one.quality, 3), numbers::fixed(one.smallest_dihedral, 1)});
  const QSignalBlocker silent(worst_);
  worst_->setContent({tr("Worst in"), tr("Quality"), tr("Angle °")}, rows, {true, false, false});
  worst_->setCurrentCell(-1, -1);
}

void MeshPanel::goTo(int row) {
  if (!survey_.mesh() || row < 0 || row >= static_cast<int>(survey_.mesh()->worst.size())) return;
  const PoorTetrahedron& one = survey_.mesh()->worst[static_cast<std::size_t>(row)];
  const MarkedPlace place{one.centre, surroundings * sizeOf(*project_.system(), one),
                          tr("quality %1, %2°")
                              .arg(numbers::fixed(one.quality, 3), numbers::fixed(one.smallest_dihedral, 1))
                              .toStdString()};
  project_.selection().select({Item::Kind::block, one.block});
  display_.mark({place});
  display_.showPlace(place);
}

}  // namespace talus
