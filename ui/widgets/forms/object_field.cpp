#include "widgets/forms/object_field.hpp"

#include <QComboBox>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

#include "document/document.hpp"
#include "document/edits.hpp"
#include "document/names.hpp"
#include "widgets/kit/display_units.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

const QString depth_key = QStringLiteral("forms/depth");

QLabel* makeTitle(const FieldSite& field) {
  // A number says its unit itself; numbers in a row have it in their title.
  const bool vector = schema::kindOf(field.rule) == schema::Kind::numbers && (field.isSet() || !field.optional);
  const QString unit = vector ? units::shown(field.word("unit"), field.word("shown")) : QString();
  auto* title =
      makeWrappedLabel(unit.isEmpty() ? field.title() : QObject::tr("%1, %2").arg(field.title(), unit), "muted");
  title->setMinimumHeight(theme::now().metrics.control);
  title->setToolTip(field.tip());
  return title;
}

/// A long word of another language is broken into lines beside its field.
void narrow(QLabel& title) {
  title.setFixedWidth(title_width);
  title.setWordWrap(true);
}

/// The same whatever the order of keys.
bool sayTheSame(const schema::Json& a, const schema::Json& b) { return nlohmann::json(a) == nlohmann::json(b); }

}  // namespace

ObjectField::ObjectField(const FieldSite& place, QWidget* parent, bool withoutThings) : FormField(place, parent) {
  const Depth depth = site().rule.contains("presets") ? addPresets() : Depth::all;
  if (depth != Depth::none) addMembers(depth, withoutThings);
}

void ObjectField::addMembers(Depth depth, bool withoutThings) {
  const auto choices = schema::variants(site().rule);
  bool variantShown = false;
  for (const auto& [key, ignored] : site().rule.at("properties").items()) {
    const FieldSite field = site().member(key);
    if (std::find(choices.begin(), choices.end(), key) != choices.end() && !variantShown) {
      addVariantRow();
      variantShown = true;
    }
    if (isShown(key, field, withoutThings) && (depth == Depth::all || field.isSet())) addRow(field);
  }
}

bool ObjectField::isShown(const std::string& key, const FieldSite& field, bool withoutThings) const {
  const schema::Kind kind = schema::kindOf(field.rule);
  if (kind == schema::Kind::constant) return false;
  if (withoutThings && (kind == schema::Kind::list || kind == schema::Kind::named || kind == schema::Kind::object))
    return false;
  const auto choices = schema::variants(site().rule);
  const auto isChoice = [&](const std::string& one) {
    return std::find(choices.begin(), choices.end(), one) != choices.end();
  };
  if (isChoice(key)) return field.isSet();
  for (const auto& partner : schema::neededBy(site().rule, key))  // the scale of a file that there is not
    if (isChoice(partner) && !site().member(partner).isSet()) return false;
  return true;
}

void ObjectField::addVariantRow() {
  auto* box = makeCombo({}, site().word("variant"));
  box->setObjectName(text(site().place.to_string()) + QStringLiteral("#variant"));
  const auto choices = schema::variants(site().rule);
  for (const auto& key : choices) {
    box->addItem(site().member(key).title());
    if (site().member(key).isSet()) box->setCurrentIndex(box->count() - 1);
  }
  connect(box, &QComboBox::activated, this, [this, box, choices, before = box->currentIndex()](int chosen) {
    if (chosen == before) return;
    const auto& project = site().context.document.json();
    const QString what =
        tr("change %1 of %2")
            .arg(schema::withinSentence(site().word("variant")), names::described(site().place, project));
    const auto edit = [&](Json& changed) {
      edits::setVariant(changed, site().place, choices[static_cast<std::size_t>(chosen)]);
    };
    if (!change(what, edit)) box->setCurrentIndex(before);
  });
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  setMargins(layout, 0, 8);
  auto* title = makeLabel(site().word("variant"), "muted");
  narrow(*title);
  layout->addWidget(title);
  layout->addWidget(box, 1);
  add(row);
}

QWidget* ObjectField::makeUnset(const FieldSite& field) {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  setMargins(layout, 0, 4);
  layout->addWidget(new ElidedLabel(field.absent(), "faint"), 1);
  auto* button = makeButton(tr("Set"), "link");
  button->setObjectName(text(field.place.to_string()) + QStringLiteral("#set"));
  button->setAccessibleName(tr("Set %1").arg(schema::withinSentence(field.title())));
  connect(button, &QPushButton::clicked, this, [this, field] {
    const auto& project = site().context.document.json();
    change(tr("set %1 of %2").arg(schema::withinSentence(field.title()), names::described(site().place, project)),
           [&](Json& changed) { edits::set(changed, field.place, edits::startOf(field.rule, changed)); });
  });
  layout->addWidget(button);
  return row;
}

QWidget* ObjectField::makeClear(const FieldSite& field) {
  auto* button = makeTool(QStringLiteral("close"), tr("Leave it out: %1").arg(field.absent()));
  button->setObjectName(text(field.place.to_string()) + QStringLiteral("#clear"));
  button->setFixedSize(theme::now().metrics.row, theme::now().metrics.row);  // as high as a field
  connect(button, &QToolButton::clicked, this, [this, field] {
    const auto& project = site().context.document.json();
    change(tr("leave out %1 of %2").arg(schema::withinSentence(field.title()), names::described(site().place, project)),
           [&](Json& changed) { edits::clear(changed, field.place); });
  });
  return button;
}

void ObjectField::addRow(const FieldSite& field) {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  setMargins(layout, 0, 8);
  auto* title = makeTitle(field);
  layout->addWidget(title, 0, Qt::AlignTop);
  const schema::Kind kind = schema::kindOf(field.rule);
  const bool isChosen = kind == schema::Kind::choice || kind == schema::Kind::boolean;  // the usual is an entry of it
  const bool mayBeCleared = field.optional && field.isSet() && !isChosen;
  if (!isWide(field.rule)) {
    narrow(*title);
    layout->addWidget(makeField(field, row), 1);
    if (mayBeCleared) layout->addWidget(makeClear(field), 0, Qt::AlignTop);
    return add(row);
  }
  const bool unset = field.optional && !field.isSet();
  if (unset) narrow(*title);
  layout->addWidget(unset ? makeUnset(field) : new QWidget, 1);
  if (mayBeCleared) layout->addWidget(makeClear(field));
  add(row);
  if (unset) return;
  auto* inside = new QWidget(this);
  auto* column = new QVBoxLayout(inside);
  const bool indented = kind == schema::Kind::object || kind == schema::Kind::list || kind == schema::Kind::named;
  column->setContentsMargins(indented ? 12 : 0, 0, 0, 4);
  column->addWidget(makeField(field, inside));
  add(inside);
}

ObjectField::Depth ObjectField::addPresets() {
  const Json presets = site().rule.at("presets");
  const Json present = site().isSet() ? *site().value() : Json::object();
  auto* choice = makeCombo({}, tr("Settings"));
  choice->setObjectName(text(site().place.to_string()) + QStringLiteral("#preset"));
  choice->setToolTip(
      tr("Draft: steps as long as loose limits allow. Standard: what the program takes of itself. "
         "Reference: tight limits, no block sleeps."));
  for (const auto& [name, values] : presets.items()) {
    choice->addItem(schema::choiceWords(name));
    if (sayTheSame(values, present)) choice->setCurrentIndex(choice->count() - 1);
  }
  const bool own =
      std::none_of(presets.begin(), presets.end(), [&](const Json& one) { return sayTheSame(one, present); });
  if (own) {
    choice->addItem(tr("own"));
    choice->setCurrentIndex(choice->count() - 1);
  }
  connect(choice, &QComboBox::activated, this, [this, presets](int chosen) {
    const auto preset = std::next(presets.begin(), chosen);
    if (preset == presets.end()) return;
    change(
        tr("use the %1 settings of %2").arg(schema::choiceWords(preset.key()), schema::withinSentence(site().title())),
        [&](Json& changed) {
          preset.value().empty() ? edits::clear(changed, site().place)
                                 : edits::set(changed, site().place, preset.value());
        });
  });
  auto* depth = makeCombo({tr("all fields"), tr("what the file says"), tr("nothing more")}, tr("Show"));
  depth->setObjectName(text(site().place.to_string()) + QStringLiteral("#depth"));
  depth->setToolTip(tr("How many of the fields are listed below"));
  depth->setCurrentIndex(QSettings().value(depth_key, 0).toInt());
  connect(depth, &QComboBox::activated, this, [this](int chosen) {
    QSettings().setValue(depth_key, chosen);
    site().context.refresh();
  });
  for (auto* box : {choice, depth}) {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    setMargins(layout, 0, 8);
    auto* title = makeLabel(box->accessibleName(), "muted");
    narrow(*title);
    layout->addWidget(title);
    layout->addWidget(box, 1);
    add(row);
  }
  return static_cast<Depth>(depth->currentIndex());
}

}  // namespace talus
