#include "widgets/geometry/section_editor.hpp"

#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "base/error.hpp"
#include "session/current_project.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

const QSize usual_editor_size(980, 560);
constexpr int numbers_width = 300, soon_ms = 120, no_drag = -1;

}  // namespace

SectionEditor::SectionEditor(CurrentProject& project, QWidget* parent)
    : QDialog(parent), project_(project), context_{project.document(), {}, nullptr, [this] { soon_.start(); }} {
  setWindowTitle(tr("Section"));
  resizeWithin(*this, usual_editor_size);
  auto* row = new QHBoxLayout(this);
  setMargins(row, 0, 0);
  auto* drawn = makePlane("surface");
  auto* column = new QVBoxLayout(drawn);
  setMargins(column, 0, 0);
  title_ = makeLabel({}, "title");
  auto* fit = makeAction(QStringLiteral("fit"), tr("Fit"), tr("Show all of the profile (double click)"));
  auto* head = new QHBoxLayout;
  head->setContentsMargins(16, 10, 12, 4);
  head->addWidget(title_, 1);
  head->addWidget(fit);
  column->addLayout(head);
  plot_ = new SectionPlot;
  column->addWidget(plot_, 1);
  problem_ = makeWrappedLabel({}, "error");
  problem_->setObjectName(QStringLiteral("problem"));
  auto* hint =
      makeWrappedLabel(tr("Drag a corner, Shift snaps; click an edge for a new one; Delete takes one away."), "small");
  for (auto* words : {problem_, hint}) {
    words->setContentsMargins(16, 2, 16, 6);
    column->addWidget(words);
  }
  problem_->hide();
  row->addWidget(drawn, 1);
  row->addWidget(makeLine(Qt::Vertical));
  auto* numbers = makePlane("surface");
  numbers->setFixedWidth(numbers_width);
  side_ = new QVBoxLayout(numbers);
  side_->setContentsMargins(0, 8, 0, 8);
  row->addWidget(numbers);
  soon_.setSingleShot(true);
  soon_.setInterval(soon_ms);
  connect(&soon_, &QTimer::timeout, this, &SectionEditor::rebuildForm);
  connect(fit, &QToolButton::clicked, plot_, &SectionPlot::fit);
  connect(plot_, &SectionPlot::edited, this, &SectionEditor::take);
  connect(&project_.selection(), &Selection::changed, this, &SectionEditor::choose);
  connect(&project_.document(), &Document::projectChanged, this, &SectionEditor::refresh);
  connect(&project_, &CurrentProject::opened, this, &QDialog::hide);
}

void SectionEditor::present() {
  choose();
  show();
  raise();
  activateWindow();
  plot_->setFocus();
}

void SectionEditor::choose() {
  const Item& item = project_.selection().current();
  const auto& solids = project_.document().project().solids;
  if (item.kind != Item::Kind::solid) return;  // the one that is shown stays
  const auto number = static_cast<std::size_t>(item.index);
  if (number >= solids.size() || !std::holds_alternative<SectionShape>(solids[number].shape)) return;
  const bool another = item.index != solid_;
  solid_ = item.index;
  refresh();
  if (another) plot_->fit();
}

void SectionEditor::refresh() {
  const auto& solids = project_.document().project().solids;
  const auto number = static_cast<std::size_t>(solid_);
  const bool isThere =
      solid_ >= 0 && number < solids.size() && std::holds_alternative<SectionShape>(solids[number].shape);
  if (!isThere) {
    solid_ = -1;
    return hide();
  }
  title_->setText(text(solids[number].name));
  plot_->setCorners(std::get<SectionShape>(solids[number].shape).points);
  plot_->setRefused(false);
  problem_->hide();
  soon_.start();
}

void SectionEditor::rebuildForm() {
  if (solid_ < 0) return;
  const schema::Place place = schema::Place("/solids") / static_cast<std::size_t>(solid_) / "section";
  delete form_;
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 4, 12, 8);
  column->addWidget(makeField({context_, place, schema::ruleOf(place)}, content));
  column->addStretch();
  form_ = makeScrolled(content);
  side_->addWidget(form_, 1);
}

void SectionEditor::take(const SectionPlot::Corners& corners, bool ends) {
  if (solid_ < 0) return;
  Document& document = project_.document();
  Project project = document.project();
  Solid& solid = project.solids[static_cast<std::size_t>(solid_)];
  std::get<SectionShape>(solid.shape).points = corners;
  if (gesture_ == no_drag) gesture_ = document.newGesture();
  const int gesture = gesture_;
  if (ends) gesture_ = no_drag;
  try {
    document.change(project, tr("change the profile of %1").arg(text(solid.name)), gesture);
  } catch (const InputError& error) {
    if (ends) refresh();  // back to what is possible
    plot_->setRefused(!ends);
    problem_->setText(tr("%1; %2").arg(text(error.problem()), text(error.remedy())));
    problem_->show();
  }
}

}  // namespace talus
