#include "widgets/forms/row_fields.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QPointer>

#include "document/document.hpp"
#include "document/edits.hpp"
#include "document/names.hpp"
#include "session/picking.hpp"
#include "widgets/forms/scalar_fields.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int in_a_row = 3;
constexpr double beneath = 1e-3;  // m, under the surface that was picked: a point inside the block

/// The thing has its place inside a block that it names by it: it would be in doubt on a surface.
bool liesInside(const schema::Place& place) {
  const std::string list = schema::Place(place.parent_pointer().parent_pointer()).to_string();
  return list == "/blocks" || list == "/merges";
}

/// A grid with a faint caption over each editor.
QWidget* makeGrid(const std::vector<QWidget*>& editors, const schema::Json& rule, QWidget* parent) {
  auto* grid = new QWidget(parent);
  auto* layout = new QGridLayout(grid);
  setMargins(layout, 0, 2);
  layout->setHorizontalSpacing(6);
  const schema::Json columns = rule.value("columns", schema::Json::array());
  for (std::size_t i = 0; i < editors.size(); ++i) {
    const int row = static_cast<int>(i) / in_a_row * 2, column = static_cast<int>(i) % in_a_row;
    if (i < columns.size())
      layout->addWidget(makeLabel(schema::choiceWords(columns.at(i).get<std::string>()), "faint"), row, column);
    layout->addWidget(editors[i], row + 1, column);
    layout->setColumnStretch(column, 1);
  }
  return grid;
}

}  // namespace

VectorField::VectorField(const FieldSite& place, QWidget* parent) : FormField(place, parent) {
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
  QWidget* grid = makeGrid(entries, site().rule, this);
  if (site().context.picking && site().rule.value("of", std::string()) == "at")
    static_cast<QGridLayout*>(grid->layout())->addWidget(makePickButton(), 1, in_a_row);
  add(grid);
}

QWidget* VectorField::makePickButton() {
  auto* button = makeTool(QStringLiteral("point"), tr("Pick it in the view"));
  button->setObjectName(text(site().place.to_string()) + QStringLiteral("#pick"));
  connect(button, &QToolButton::clicked, this, [this] { askForPlace(*site().context.picking); });
  return button;
}

void VectorField::askForPlace(Picking& picking) {
  const QString prompt = tr("Click the place of: %1").arg(schema::withinSentence(site().title()));
  picking.ask(prompt, 1, [field = QPointer(this)](const std::vector<PickedPlace>& places) {
    if (field) field->takePlace(places.at(0));
  });
  connect(this, &QObject::destroyed, &picking, [&picking, prompt] {
    if (picking.prompt() == prompt) picking.cancel();
  });
}

void VectorField::takePlace(const PickedPlace& picked) {
  const schema::Place& place = site().place;
  const Vec3 point = liesInside(place) ? Vec3(picked.point - beneath * picked.normal) : picked.point;
  const schema::Place block = place.parent_pointer() / "block";
  const Json blockRule = schema::memberRule(schema::ruleOf(place.parent_pointer()), "block");
  const auto& blocks = site().context.blocks;
  const bool takesBlock = blockRule.is_object() && blockRule.value("of", std::string()) == "block_name" &&
                          picked.block >= 0 && picked.block < static_cast<int>(blocks.size());
  change(tr("pick %1 of %2")
             .arg(schema::withinSentence(site().title()),
                  names::described(place.parent_pointer(), site().context.document.json())),
         [&](Json& project) {
           edits::set(project, place, edits::placeJson(point));
           if (takesBlock) edits::set(project, block, blocks[static_cast<std::size_t>(picked.block)]);
         });
}

NamesField::NamesField(const FieldSite& place, QWidget* parent) : FormField(place, parent) {
  std::vector<QWidget*> boxes;
  for (std::size_t i = 0; i < site().rule.at("minItems"); ++i)
    boxes.push_back(makeNameBox(site().element(i), [this, i](const QString& name) {
      Json all = site().isSet() ? *site().value() : edits::startOf(site().rule, site().context.document.json());
      all[i] = name.toStdString();
      put(all);
    }));
  add(makeGrid(boxes, site().rule, this));
}

}  // namespace talus
