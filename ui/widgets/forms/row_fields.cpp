#include "widgets/forms/row_fields.hpp"

#include <QComboBox>
#include <QGridLayout>

#include "document/document.hpp"
#include "document/edits.hpp"
#include "widgets/forms/scalar_fields.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int in_a_row = 3;

/// A grid with a faint caption over each editor.
QWidget* makeGrid(const std::vector<QWidget*>& editors, const schema::Json& rule) {
  auto* grid = new QWidget;
  auto* layout = new QGridLayout(grid);
  setMargins(layout, 0, 2);
  layout->setHorizontalSpacing(6);
  const schema::Json columns = rule.value("columns", schema::Json::array());
  for (std::size_t i = 0; i < editors.size(); ++i) {
    const int row = static_cast<int>(i) / in_a_row * 2, column = static_cast<int>(i) % in_a_row;
    if (i < columns.size()) layout->addWidget(makeLabel(text(columns.at(i).get<std::string>()), "faint"), row, column);
    layout->addWidget(editors[i], row + 1, column);
    layout->setColumnStretch(column, 1);
  }
  return grid;
}

}  // namespace

VectorField::VectorField(const FieldSite& place) : FormField(place) {
  const Json* present = site().value();
  std::vector<QWidget*> entries;
  for (std::size_t i = 0; i < site().rule.at("minItems"); ++i) {
    const FieldSite each = site().element(i);
    const bool mayBeNull = each.rule.at("type").is_array();
    const QString none = mayBeNull ? each.word("absent") : present ? QString() : QStringLiteral("–");
    auto* entry = makeNumber(each.rule, present ? &present->at(i) : nullptr, none, {}, false);
    entry->setObjectName(text(each.place.to_string()));
    entry->setAccessibleName(site().title() + u' ' + QString::number(i + 1));
    connect(entry, &NumberField::problemChanged, this, &FormField::say);
    const auto putOne = [this, i](const Json& number) {
      Json all = site().isSet() ? *site().value() : edits::startOf(site().rule, site().context.document.json());
      all[i] = number;
      put(all);
    };
    connect(entry, &NumberField::committed, this, [putOne](double number) { putOne(jsonOf(number)); });
    connect(entry, &NumberField::cleared, this, [putOne] { putOne(nullptr); });
    entries.push_back(entry);
  }
  add(makeGrid(entries, site().rule));
}

NamesField::NamesField(const FieldSite& place) : FormField(place) {
  std::vector<QWidget*> boxes;
  for (std::size_t i = 0; i < site().rule.at("minItems"); ++i)
    boxes.push_back(makeNameBox(site().element(i), [this, i](const QString& name) {
      Json all = site().isSet() ? *site().value() : edits::startOf(site().rule, site().context.document.json());
      all[i] = name.toStdString();
      put(all);
    }));
  add(makeGrid(boxes, site().rule));
}

}  // namespace talus
