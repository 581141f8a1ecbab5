#include "widgets/actions/vector_dialog.hpp"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "base/quantity_text.hpp"
#include "base/units.hpp"
#include "widgets/kit/display_units.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int vector_width = 380;
enum Way { down, up, by_line, into_face, out_of_face };

}  // namespace

VectorDialog::VectorDialog(Question question, QWidget* parent)
    : QDialog(parent), question_(std::move(question)), amount_(question_.preset), rows_(new QFormLayout) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(question_.title);
  resize(vector_width, sizeHint().height());
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* content = new QVBoxLayout;
  content->setContentsMargins(16, 14, 16, 14);
  content->setSpacing(10);
  content->addWidget(makeWrappedLabel(question_.about, "muted"));
  rows_->setHorizontalSpacing(12);
  content->addLayout(rows_);
  outcome_ = makeWrappedLabel({}, "small");
  content->addWidget(outcome_);
  column->addLayout(content);
  auto* bar = makePlane("bottom");
  auto* buttons = new QHBoxLayout(bar);
  buttons->setContentsMargins(16, 10, 16, 10);
  buttons->addStretch();
  auto* cancel = makeButton(tr("Cancel"));
  cancel->setAutoDefault(false);
  create_ = makeButton(tr("Create"), "primary");
  create_->setObjectName(QStringLiteral("vector#create"));
  create_->setDefault(true);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(create_, &QPushButton::clicked, this, &QDialog::accept);
  buttons->addWidget(cancel);
  buttons->addWidget(create_);
  column->addWidget(bar);
  addAmounts();
  addDirections();
  refresh();
}

NumberField* VectorDialog::addNumber(const QString& name, const QString& tip, double& value, const QString& kept,
                                     const QString& shown) {
  auto* field = new NumberField(value, {kept, units::shown(kept, shown)});
  field->setAccessibleName(name);
  field->setMeaning(tip);
  rows_->addRow(makeLabel(name), field);
  connect(field, &NumberField::committed, this, [this, field, &value](double number) {
    value = number;
    field->setValue(number);
    refresh();
  });
  connect(field, &NumberField::problemChanged, this, [this](const QString& problem) {
    create_->setEnabled(problem.isEmpty());
    setRole(outcome_, problem.isEmpty() ? "small" : "error");
    problem.isEmpty() ? refresh() : outcome_->setText(problem);
  });
  return field;
}

void VectorDialog::addAmounts() {
  if (question_.face) {
    as_ = makeCombo({tr("Force"), tr("Pressure on the face")}, tr("Said as"));
    as_->setObjectName(QStringLiteral("vector#as"));
    as_->setToolTip(tr("The resultant itself, or a pressure that is multiplied by the face's area"));
    rows_->addRow(makeLabel(tr("Said as")), as_);
    connect(as_, &QComboBox::currentIndexChanged, this, &VectorDialog::refresh);
  }
  amountField_ = addNumber(tr("Size"), tr("How large it is, in %1 or any other unit of its kind").arg(question_.shown),
                           amount_, question_.kept, question_.shown);
  amountField_->setObjectName(QStringLiteral("vector#amount"));
  if (!question_.face) return;
  pressure_ = amount_ / question_.face->area;
  pressureField_ = addNumber(tr("Pressure"), tr("Force per area of the face, in kPa or any other unit of stress"),
                             pressure_, QStringLiteral("Pa"), QStringLiteral("kPa"));
  pressureField_->setObjectName(QStringLiteral("vector#pressure"));
}

void VectorDialog::addDirections() {
  way_ = makeCombo({tr("Down"), tr("Up"), tr("By trend and plunge")}, tr("Direction"));
  if (question_.face) way_->addItems({tr("Into the face"), tr("Out of the face")});
  way_->setObjectName(QStringLiteral("vector#direction"));
  way_->setToolTip(tr("Which way it goes"));
  rows_->addRow(makeLabel(tr("Direction")), way_);
  trendField_ = addNumber(tr("Trend"), tr("Direction on the map, degrees clockwise from north"), trend_,
                          QStringLiteral("°"), QStringLiteral("°"));
  trendField_->setObjectName(QStringLiteral("vector#trend"));
  plungeField_ = addNumber(tr("Plunge"), tr("Angle below the horizontal, degrees; negative: upwards"), plunge_,
                           QStringLiteral("°"), QStringLiteral("°"));
  plungeField_->setObjectName(QStringLiteral("vector#plunge"));
  if (question_.face) way_->setCurrentIndex(into_face);
  connect(way_, &QComboBox::currentIndexChanged, this, &VectorDialog::refresh);
}

double VectorDialog::size() const {
  const bool asPressure = as_ && as_->currentIndex() == 1;
  return asPressure ? pressure_ * question_.face->area : amount_;
}

Vec3 VectorDialog::direction() const {
  const double t = radians(trend_), p = radians(plunge_);
  switch (way_->currentIndex()) {
    case up:
      return Vec3::UnitZ();
    case by_line:
      return {std::sin(t) * std::cos(p), std::cos(t) * std::cos(p), -std::sin(p)};
    case into_face:
      return -question_.face->normal;
    case out_of_face:
      return question_.face->normal;
    default:
      return -Vec3::UnitZ();
  }
}

Vec3 VectorDialog::vector() const {
  Vec3 vector = size() * direction();
  for (double& component : vector)
    if (std::abs(component) < 1e-12 * std::abs(size())) component = 0;  // of rounding in the direction alone
  return vector;
}

void VectorDialog::refresh() {
  if (!way_ || !plungeField_) return;  // while it is being made
  const bool asPressure = as_ && as_->currentIndex() == 1;
  rows_->setRowVisible(amountField_, !asPressure);
  if (pressureField_) rows_->setRowVisible(pressureField_, asPressure);
  for (auto* field : {trendField_, plungeField_}) rows_->setRowVisible(field, way_->currentIndex() == by_line);
  const std::string kept = question_.kept.toStdString(),
                    unit = units::shown(question_.kept, question_.shown).toStdString();
  const auto shown = [&](double value) {
    return numbers::significant(converted(value, kept, unit)) + u' ' + text(unit);
  };
  const Vec3 v = vector();
  QString words = tr("x %1, y %2, z %3").arg(shown(v.x()), shown(v.y()), shown(v.z()));
  if (question_.face)
    words = tr("%1 on %2 m²: ").arg(shown(size()), numbers::significant(question_.face->area)) + words;
  outcome_->setText(words);
}

}  // namespace talus
