#include "widgets/geometry/move_dialog.hpp"

#include <QComboBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "base/error.hpp"
#include "geometry/solid_surface.hpp"
#include "model/solid_moves.hpp"
#include "session/current_project.hpp"
#include "session/solid_surfaces.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int dialog_width = 340, most_copies = 1000;

/// Middle of the box around some solids, to a millimetre; zero where none of them is there yet.
Vec3 middleOf(const CurrentProject& project, const SolidSurfaces& shown, const std::vector<int>& solids) {
  Vec3 low = Vec3::Constant(HUGE_VAL), high = -low;
  const auto* surfaces = shown.current();
  for (const int solid : solids)
    for (std::size_t i = 0; surfaces && i < surfaces->size(); ++i) {
      if ((*surfaces)[i].name != project.document().project().solids[static_cast<std::size_t>(solid)].name) continue;
      low = low.cwiseMin((*surfaces)[i].min);
      high = high.cwiseMax((*surfaces)[i].max);
    }
  if (low.x() > high.x()) return Vec3::Zero();
  return (500 * (low + high)).array().round() / 1000;
}

}  // namespace

MoveDialog::MoveDialog(CurrentProject& project, SolidSurfaces& surfaces, Kind kind, std::vector<int> solids,
                       QWidget* parent)
    : QDialog(parent),
      project_(project),
      surfaces_(surfaces),
      kind_(kind),
      solids_(std::move(solids)),
      about_(middleOf(project, surfaces, solids_)) {
  setWindowTitle(title());
  setFixedWidth(dialog_width);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 14, 16, 12);
  column->setSpacing(10);
  rows_ = new QFormLayout;
  setMargins(rows_, 0, 6);
  rows_->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  column->addLayout(rows_);
  if (kind_ == Kind::move) addVector(tr("By"), step_);
  if (kind_ == Kind::copy) {
    addVector(tr("Each further by"), step_);
    addNumber(tr("Copies"), count_, {});
  }
  if (kind_ == Kind::turn) {
    addAxis();
    addNumber(tr("Angle"), angle_, QStringLiteral("°"));
  }
  if (kind_ == Kind::scale) addNumber(tr("Factor"), factor_, {});
  if (kind_ == Kind::turn || kind_ == Kind::scale) addVector(tr("About"), about_);
  refusal_ = makeWrappedLabel({}, "error");
  refusal_->setObjectName(QStringLiteral("refusal"));
  column->addWidget(refusal_);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  auto* cancel = makeButton(tr("Cancel"));
  apply_ = makeButton(tr("Apply"), "primary");
  apply_->setObjectName(QStringLiteral("apply"));
  apply_->setEnabled(false);
  for (auto* button : {cancel, apply_}) {
    button->setAutoDefault(false);
    buttons->addWidget(button);
  }
  column->addLayout(buttons);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(apply_, &QPushButton::clicked, this, &MoveDialog::apply);
  connect(&project_.document(), &Document::projectChanged, this, &QDialog::reject);
  connect(&project_, &CurrentProject::opened, this, &QDialog::reject);
}

MoveDialog::~MoveDialog() { surfaces_.propose({}); }

QString MoveDialog::title() const {
  const auto& solids = project_.document().project().solids;
  const QString what = solids_.size() == 1 ? text(solids[static_cast<std::size_t>(solids_[0])].name)
                                           : numbers::counted(solids_.size(), "solid");
  switch (kind_) {
    case Kind::move:
      return tr("Move %1").arg(what);
    case Kind::turn:
      return tr("Turn %1").arg(what);
    case Kind::scale:
      return tr("Scale %1").arg(what);
    case Kind::copy:
      break;
  }
  return tr("Copy %1").arg(what);
}

NumberField* MoveDialog::addNumber(const QString& name, double& kept, const QString& unit) {
  auto* field = new NumberField(kept, {unit, unit});
  field->setAccessibleName(name);
  connect(field, &NumberField::committed, this, [this, field, &kept](double value) {
    kept = value;
    field->setValue(value);
    propose();
  });
  rows_->addRow(name, field);
  return field;
}

void MoveDialog::addVector(const QString& name, Vec3& kept) {
  const QString axes[] = {tr("east, x"), tr("north, y"), tr("up, z")};
  rows_->addRow(makeLabel(name, "section"));
  for (int i = 0; i < 3; ++i) addNumber(axes[i], kept[i], QStringLiteral("m"));
}

void MoveDialog::addAxis() {
  auto* axis = makeCombo({tr("upright, z"), tr("to the east, x"), tr("to the north, y")}, tr("Axis"));
  axis->setToolTip(tr("By the right hand: about the upright axis, counter-clockwise seen from above"));
  rows_->addRow(tr("Axis"), axis);
  connect(axis, &QComboBox::activated, this, [this](int index) {
    axis_ = index == 0 ? Vec3::UnitZ() : index == 1 ? Vec3::UnitX() : Vec3::UnitY();
    propose();
  });
}

Project MoveDialog::changed() const {
  Project project = project_.document().project();
  if (kind_ == Kind::copy) {
    if (count_ < 1 || count_ > most_copies || count_ != std::floor(count_))
      throw InputError("copies", "their number is a whole one from 1 to 1000", "give 1 for one copy");
    // From behind: copies stand behind their solid, and the numbers before them stay.
    for (auto solid = solids_.rbegin(); solid != solids_.rend(); ++solid)
      project = with_copies(std::move(project), *solid, static_cast<int>(count_), step_);
    return project;
  }
  if (kind_ == Kind::scale && !(factor_ > 0))
    throw InputError("factor", "a factor is above 0", "give 2 for twice as large");
  for (const int number : solids_) {
    Solid& solid = project.solids[static_cast<std::size_t>(number)];
    if (kind_ == Kind::move) solid = moved(solid, step_);
    if (kind_ == Kind::turn) solid = turned(solid, {axis_, angle_, about_});
    if (kind_ == Kind::scale) solid = scaled(solid, factor_, about_, project.origin);
  }
  return project;
}

void MoveDialog::propose() {
  try {
    surfaces_.propose(changed());
    refusal_->clear();
    apply_->setEnabled(true);
  } catch (const InputError& error) {
    surfaces_.propose({});
    refusal_->setText(tr("%1; %2").arg(text(error.problem()), text(error.remedy())));
    apply_->setEnabled(false);
  }
}

void MoveDialog::apply() {
  try {
    const QString what = title();
    project_.document().change(changed(), what.left(1).toLower() + what.mid(1));  // which closes the dialog
    accept();
  } catch (const InputError& error) {
    refusal_->setText(tr("%1; %2").arg(text(error.problem()), text(error.remedy())));
  }
}

}  // namespace talus
