#include "widgets/blocks/mesh_panel.hpp"

#include <QComboBox>

#include "base/error.hpp"
#include "document/edits.hpp"
#include "geometry/mesh_estimate.hpp"
#include "mesh/mesh_size.hpp"
#include "mesh/picked_face.hpp"
#include "session/session.hpp"
#include "widgets/blocks/block_columns.hpp"
#include "widgets/blocks/block_table.hpp"
#include "widgets/blocks/quality_chart.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int chart_width = 210, worst_width = 240;  // leave the table five whole columns on the smallest screen
/// Below these a tetrahedron is stiff, and a step of it small: limits that meshers commonly warn at.
constexpr double poor_ratio = 0.2, poor_angle = 10;
constexpr double refined_reach = 2, finer = 0.5;  // of a refinement that is made, over the edges of the block
constexpr double surroundings = 3;                // what the view shows round a tetrahedron, over its edges

/// The longest edge [m].
double sizeOf(const BlockSystem& system, const PoorTetrahedron& one) {
  const TetMesh& mesh = system.blocks[static_cast<std::size_t>(one.block)].mesh;
  const auto& nodes = mesh.tetrahedra[static_cast<std::size_t>(one.tetrahedron)];
  double longest = 0;
  for (const int a : nodes)
    for (const int b : nodes) longest = std::max(longest, (mesh.nodes[a] - mesh.nodes[b]).norm());
  return longest;
}

QString megabytes(double bytes) {
  return bytes < 1e9 ? QObject::tr("%1 MB").arg(numbers::significant(bytes / 1e6, 2))
                     : QObject::tr("%1 GB").arg(numbers::significant(bytes / 1e9, 2));
}

/// They are cut alike, but for how blocks are made and meshed.
bool haveTheSameRock(const Project& a, const Project& b) {
  const auto shapes = [](std::vector<Solid> solids) {
    for (Solid& solid : solids) {
      solid.mesh_size.reset();
      solid.body = {};
      solid.material.clear();
    }
    return solids;
  };
  return a.cuts == b.cuts && a.merges == b.merges && shapes(a.solids) == shapes(b.solids);
}

}  // namespace

MeshPanel::MeshPanel(Session& session) : session_(session), table_(new BlockTable(session.project)) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  column->addWidget(makeHead());
  auto* row = new QHBoxLayout;
  setMargins(row, 0, 0);
  table_->setObjectName(QStringLiteral("mesh"));
  table_->setAccessibleName(tr("Mesh of each block"));
  row->addWidget(table_, 1);
  row->addWidget(makeLine(Qt::Vertical));
  row->addWidget(makeChart());
  row->addWidget(makeLine(Qt::Vertical));
  row->addWidget(makeWorst());
  column->addLayout(row, 1);
  connect(&session_.survey, &BlockSurvey::changed, this, &MeshPanel::refresh);
  connect(&session_.project.document(), &Document::projectChanged, this, [this] {
    emit titleChanged(title());
    offerRefining();
    if (isVisible()) showAhead();
  });
  connect(&session_.project, &CurrentProject::opened, this, &MeshPanel::offerRefining);
  offerRefining();
  refresh();
}

QWidget* MeshPanel::makeHead() {
  auto* head = makePlane("header");
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(12, 3, 12, 3);
  const auto addRefining = [&](QToolButton* button, const QString& name, const QString& question, bool wholeFace) {
    button->setObjectName(name);
    connect(button, &QToolButton::clicked, this, [=, this] {
      session_.picking.ask(question, 1, [=, this](const auto& places) { refineAt(places.front(), wholeFace); });
    });
    refining_.emplace_back(button, button->toolTip());
    row->addWidget(button);
  };
  addRefining(makeAction(QStringLiteral("point"), tr("Refine near a place"),
                         tr("A click in the view says where the mesh becomes finer; the form of the mesh says how far "
                            "and how much")),
              QStringLiteral("refine"), tr("Click the place near which the mesh shall be finer"), false);
  addRefining(
      makeAction(QStringLiteral("section"), tr("Refine near a face"),
                 tr("A click on a flat face says along which the mesh becomes finer; the form of the mesh says how far "
                    "and how much")),
      QStringLiteral("refine face"), tr("Click the face near which the mesh shall be finer"), true);
  row->addSpacing(8);
  ahead_ = new ElidedLabel({}, "small");
  ahead_->setObjectName(QStringLiteral("ahead"));
  row->addWidget(ahead_, 1);
  return head;
}

void MeshPanel::offerRefining() {
  const bool isRock = !session_.project.document().project().solids.empty();
  for (const auto& [button, words] : refining_) {
    button->setEnabled(isRock);
    button->setToolTip(isRock ? words : tr("There is no rock yet"));
  }
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
  return session_.project.system() && !session_.project.systemIsCurrent() ? tr("Mesh, before the last change")
                                                                          : tr("Mesh");
}

void MeshPanel::showEvent(QShowEvent* event) {
  session_.survey.want();
  refresh();
  QWidget::showEvent(event);
}

void MeshPanel::hideEvent(QHideEvent* event) {
  session_.display.mark({});
  QWidget::hideEvent(event);
}

void MeshPanel::refresh() {
  emit titleChanged(title());
  if (!isVisible()) return;
  table_->setEmptyWords(tr("Not meshed yet."));
  std::vector<BlockColumn> columns;
  if (session_.project.system()) columns = meshColumns(session_.project.system(), session_.survey.mesh());
  table_->setContent(std::move(columns));
  showAhead();
  showChart();
  showWorst();
}

/// Of blocks that are cut as the project wants them, but meshed otherwise.
void MeshPanel::showAhead() {
  const Project& project = session_.project.document().project();
  const bool tells = session_.project.system() && !session_.project.systemIsCurrent() &&
                     haveTheSameRock(session_.project.builtFrom(), project);
  if (!tells) return ahead_->setText({});
  const MeshEstimate ahead = mesh_estimate(project, *session_.project.system());
  const bool tooMany = ahead.tetrahedra > project.mesh.most_tetrahedra;
  setRole(ahead_, tooMany ? "error" : "small");
  const QString count = numbers::significant(ahead.tetrahedra, 2);
  ahead_->setText(tooMany ? tr("Meshed anew: about %1 tetrahedra, more than the %2 that are allowed")
                                .arg(count, numbers::figure(project.mesh.most_tetrahedra, 3))
                          : tr("Meshed anew: about %1 tetrahedra, %2 unknowns, %3, %4")
                                .arg(count, numbers::significant(ahead.unknowns, 2), megabytes(ahead.bytes),
                                     numbers::duration(ahead.seconds)));
}

void MeshPanel::showChart() {
  if (!session_.survey.mesh()) return chart_->clear();
  if (measure_->currentIndex() == 0)
    chart_->show(session_.survey.mesh()->quality, poor_ratio, 1, {});
  else
    chart_->show(session_.survey.mesh()->dihedral, poor_angle, 0, QStringLiteral("°"));
}

void MeshPanel::showWorst() {
  std::vector<QStringList> rows;
  if (session_.survey.mesh())
    for (const PoorTetrahedron& one : session_.survey.mesh()->worst)
      rows.push_back({session_.project.blockName(one.block), numbers::fixed(one.quality, 3),
                      numbers::fixed(one.smallest_dihedral, 1)});
  const QSignalBlocker silent(worst_);
  worst_->setContent({tr("Worst in"), tr("Quality"), tr("Angle °")}, rows, {true, false, false});
  worst_->setCurrentCell(-1, -1);
}

void MeshPanel::refineAt(const PickedPlace& place, bool wholeFace) {
  Project changed = session_.project.document().project();
  const auto system = session_.project.system();
  if (!system || place.block < 0) return;
  const Block& block = system->blocks.at(static_cast<std::size_t>(place.block));
  const double own = mesh_size(block.mesh.nodes, block.surface);
  MeshRefinement refinement{place.point, refined_reach * own, finer * own};
  if (wholeFace)
    for (const Vec3& corner : face_at(block, place.point, place.normal).outline)
      refinement.face.push_back(edits::keptPlace(corner));
  changed.mesh.refinements.push_back(refinement);
  try {
    session_.project.document().change(
        changed, wholeFace ? tr("refine the mesh near a face") : tr("refine the mesh near a place"));
    session_.project.selection().select({Item::Kind::mesh, 0});
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error));
  }
}

void MeshPanel::goTo(int row) {
  if (!session_.survey.mesh() || row < 0 || row >= static_cast<int>(session_.survey.mesh()->worst.size())) return;
  const PoorTetrahedron& one = session_.survey.mesh()->worst[static_cast<std::size_t>(row)];
  const MarkedPlace place{one.centre, surroundings * sizeOf(*session_.project.system(), one),
                          tr("quality %1, %2°")
                              .arg(numbers::fixed(one.quality, 3), numbers::fixed(one.smallest_dihedral, 1))
                              .toStdString()};
  session_.project.selection().select({Item::Kind::block, one.block});
  session_.display.mark({place});
  session_.display.showPlace(place);
}

}  // namespace talus
