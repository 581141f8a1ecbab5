#include "widgets/begin/template_form.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/quantity_text.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int field_width = 96;

QString noteOf(const TemplateNumber& number) {
  const QString range = text(range_text(number)).replace(u' ', QChar(QChar::Nbsp));  // stays on one line
  return TemplateForm::tr("%1; %2").arg(text(number.meaning), range);
}

}  // namespace

TemplateForm::TemplateForm(const ProjectTemplate& chosen) : chosen_(chosen) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 2);
  rows_.reserve(chosen.numbers.size());
  for (const TemplateNumber& number : chosen.numbers) {
    auto* field = new NumberField(number.preset, {text(number.unit), text(number.unit)});
    field->setMaximumWidth(field_width);
    field->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);  // of itself it takes what others leave
    field->setAccessibleName(text(number.name));
    auto* name = makeLabel(text(number.name));
    name->setBuddy(field);
    auto* line = new QHBoxLayout;
    setMargins(line, 0, 12);
    line->addWidget(name, 1);
    line->addWidget(field);
    column->addLayout(line);
    auto* note = makeWrappedLabel(noteOf(number), "small");
    note->setContentsMargins(0, 0, 0, 8);
    column->addWidget(note);
    rows_.push_back({&number, field, note, number.preset});
    connect(field, &QLineEdit::textEdited, this,
            [this, index = rows_.size() - 1](const QString& typed) { check(rows_[index], typed); });
    const auto checkShown = [this, field, index = rows_.size() - 1] { check(rows_[index], field->text()); };
    connect(field, &NumberField::committed, this, checkShown);  // the field calls any number good
    connect(field, &NumberField::takenBack, this, checkShown);
  }
}

void TemplateForm::check(Row& row, const QString& typed) {
  QString problem;
  try {
    const double value = read_quantity(typed.toStdString(), row.number->unit, row.number->unit);
    check_number(*row.number, value);
    row.value = value;
  } catch (const InputError& error) {
    problem = tr("%1; %2").arg(text(error.problem()), text(error.remedy()));
  }
  row.good = problem.isEmpty();
  row.field->setProblem(problem);
  row.note->setText(row.good ? noteOf(*row.number) : tr("%1 %2").arg(text(row.number->name), problem));
  setRole(row.note, row.good ? "small" : "error");
  emit changed();
}

bool TemplateForm::isGood() const {
  return std::all_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.good; });
}

Project TemplateForm::project() const {
  TemplateValues values;
  for (const Row& row : rows_) values[row.number->key] = row.value;
  return project_from(chosen_, values);
}

}  // namespace talus
