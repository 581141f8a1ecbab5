#include "widgets/forms/scalar_fields.hpp"

#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <algorithm>
#include <cmath>

#include "document/document.hpp"
#include "document/edits.hpp"
#include "document/names.hpp"
#include "widgets/kit/display_units.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

using schema::Json;

NumberField* makeNumber(const Json& rule, const Json* value, const QString& none, const QString& unit,
                        bool unitBehind) {
  const QString kept = unit.isEmpty() ? text(rule.value("unit", std::string())) : unit;
  const QString shown = units::shown(kept, text(rule.value("shown", std::string())));
  const bool isNumber = value && value->is_number();
  auto* field =
      new NumberField(isNumber ? std::optional(value->get<double>()) : std::nullopt, {kept, shown, unitBehind});
  if (!none.isEmpty()) field->allowNone(none);
  return field;
}

Json jsonOf(double number, bool isCount) {
  constexpr double exact = 9e15, readable = 1e6;  // whole numbers that a double holds; 2e10 reads better as it is
  if (number == std::floor(number) && std::abs(number) < (isCount ? exact : readable))
    return static_cast<std::int64_t>(number);
  return number;
}

namespace {

constexpr int shortest_entry = 80;  // pixels of text that any entry shows

bool isLong(const QString& words, const QWidget& entry) {
  return entry.fontMetrics().horizontalAdvance(words) > shortest_entry;
}

/// A text longer than its entry is seen from its beginning, and whole by its tooltip.
void showWhole(QLineEdit& entry) {
  entry.setCursorPosition(0);
  if (isLong(entry.text(), entry)) entry.setToolTip(entry.text());
}

/// What an entry says that leaves the field out: "as its solid", "newmark (usual)".
QString usualWords(const FieldSite& site) {
  return site.rule.contains("default") ? QObject::tr("%1 (usual)").arg(site.absent()) : site.absent();
}

}  // namespace

NumberEntry::NumberEntry(const FieldSite& place, QWidget* parent) : FormField(place, parent) {
  const bool mayBeNull = site().rule.at("type").is_array();
  auto* entry = makeNumber(site().rule, site().value(), mayBeNull ? site().word("absent") : site().absent());
  entry->setObjectName(text(site().place.to_string()));
  entry->setAccessibleName(site().title());
  connect(entry, &NumberField::problemChanged, this, &FormField::say);
  const bool isCount = site().rule.at("type") == "integer";
  connect(entry, &NumberField::committed, this, [this, isCount](double number) { put(jsonOf(number, isCount)); });
  connect(entry, &NumberField::cleared, this, [this, mayBeNull] { mayBeNull ? put(nullptr) : leaveOut(); });
  add(entry);
}

NamedNumberField::NamedNumberField(const FieldSite& place, QWidget* parent) : FormField(place, parent) {
  auto* box = makeCombo({}, site().title());
  box->setObjectName(text(site().place.to_string()));
  box->setEditable(true);
  box->setInsertPolicy(QComboBox::NoInsert);
  for (const auto& name : site().rule.at("named")) box->addItem(schema::choiceWords(name.get<std::string>()));
  const Json* present = site().value();
  const QString shown = !present               ? QString()
                        : present->is_number() ? numbers::inField(present->get<double>())
                                               : schema::choiceWords(present->get<std::string>());
  box->setCurrentIndex(-1);
  box->setEditText(shown);
  box->lineEdit()->setPlaceholderText(usualWords(site()));
  const auto changed = [this, box, shown] {
    if (box->currentText() != shown) commit(box->currentText());
  };
  connect(box, &QComboBox::activated, this, changed);
  connect(box->lineEdit(), &QLineEdit::editingFinished, this, changed);
  add(box);
}

void NamedNumberField::commit(const QString& typed) {
  if (typed.isEmpty()) {
    leaveOut();
    return;
  }
  for (const auto& name : site().rule.at("named")) {
    if (typed != schema::choiceWords(name.get<std::string>())) continue;
    put(name);
    return;
  }
  bool isNumber = false;
  const double number = typed.toDouble(&isNumber);
  isNumber ? put(number) : put(typed.toStdString());  // the check says what is wrong with another text
}

ChoiceField::ChoiceField(const FieldSite& place, QWidget* parent) : FormField(place, parent) {
  const bool boolean = schema::kindOf(site().rule) == schema::Kind::boolean;
  const Json values = boolean ? Json{true, false} : site().rule.at("enum");
  auto* box = makeCombo({}, site().title());
  box->setObjectName(text(site().place.to_string()));
  if (site().optional) box->addItem(usualWords(site()));
  const int first = box->count();
  for (const auto& value : values)
    box->addItem(boolean ? (value.get<bool>() ? tr("yes") : tr("no")) : schema::choiceWords(value.get<std::string>()));
  const Json* present = site().value();
  const auto at = present ? std::find(values.begin(), values.end(), *present) : values.end();
  box->setCurrentIndex(at == values.end() ? 0 : first + static_cast<int>(at - values.begin()));
  box->setProperty("unset", box->currentIndex() < first);
  connect(box, &QComboBox::activated, this, [this, box, first, values, before = box->currentIndex()](int chosen) {
    if (chosen == before) return;
    const bool done = chosen < first ? leaveOut() : put(values.at(static_cast<std::size_t>(chosen - first)));
    if (!done) box->setCurrentIndex(before);
  });
  add(box);
}

TextField::TextField(const FieldSite& place, QWidget* parent) : FormField(place, parent) {
  const Json* present = site().value();
  auto* entry = new QLineEdit(present ? text(present->get<std::string>()) : QString());
  entry->setObjectName(text(site().place.to_string()));
  entry->setAccessibleName(site().title());
  entry->setPlaceholderText(site().absent());
  entry->setMinimumWidth(60);
  showWhole(*entry);
  connect(entry, &QLineEdit::editingFinished, this, [this, entry] {
    if (!entry->isModified()) return;
    entry->setModified(false);
    commit(entry->text());
  });
  if (!site().rule.contains("file")) {
    add(entry);
    return;
  }
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  setMargins(layout, 0, 4);
  auto* browse = makeTool(QStringLiteral("folder"), tr("Choose a file"));
  layout->addWidget(entry, 1);
  layout->addWidget(browse);
  connect(browse, &QToolButton::clicked, this, [this] {
    const QString folder = text(site().context.document.folder().string());
    const QString file = QFileDialog::getOpenFileName(this, site().title(), folder, site().word("file"));
    if (!file.isEmpty()) commit(QDir(folder).relativeFilePath(file));
  });
  add(row);
}

void TextField::commit(const QString& typed) {
  if (typed.isEmpty() && site().optional) {
    leaveOut();
  } else if (site().rule.value("identifies", false)) {
    change(tr("rename %1").arg(names::described(site().place.parent_pointer(), site().context.document.json())),
           [&](Json& project) { names::rename(project, site().place.parent_pointer(), typed.toStdString()); });
  } else {
    put(typed.toStdString());
  }
}

KeyField::KeyField(const FieldSite& place, QWidget* parent) : FormField(place, parent) {
  auto* entry = new QLineEdit(text(site().place.back()));
  entry->setObjectName(text(site().place.to_string()) + QStringLiteral("#name"));
  entry->setAccessibleName(tr("Name"));
  showWhole(*entry);
  connect(entry, &QLineEdit::editingFinished, this, [this, entry] {
    if (!entry->isModified()) return;
    entry->setModified(false);
    change(tr("rename %1").arg(names::described(site().place, site().context.document.json())),
           [&](Json& project) { names::rename(project, site().place, entry->text().toStdString()); });
  });
  add(entry);
}

NameField::NameField(const FieldSite& place, QWidget* parent) : FormField(place, parent) {
  auto* box = makeNameBox(site(), [this](const QString& name) { commit(name); });
  add(box);
}

void NameField::commit(const QString& name) {
  if (name.isEmpty() && site().optional)
    leaveOut();
  else
    put(name.toStdString());
}

QComboBox* makeNameBox(const FieldSite& site, const std::function<void(const QString&)>& commit) {
  QStringList choices;
  const bool pieces = site.rule.value("pieces", false), quantity = site.rule.value("quantity", false);
  for (const auto& name : names::thatMayStand(site.rule, site.context.document.json())) choices << text(name);
  if (pieces)
    for (const auto& block : site.context.blocks)
      if (!choices.contains(text(block))) choices << text(block);
  if (quantity) {
    QStringList quantities;
    for (const QString& name : choices)
      for (const char* what : {".displacement.magnitude", ".displacement.z", ".velocity.magnitude", ".stress.zz"})
        quantities << name + QLatin1String(what);
    choices = quantities;
  }
  if (site.optional) choices.prepend(QString());
  auto* box = makeCombo(choices, site.title());
  box->setObjectName(text(site.place.to_string()));
  const schema::Json* present = site.value();
  const QString name = present ? text(present->get<std::string>()) : QString();
  if (!pieces && !quantity) {
    if (site.optional) box->setItemText(0, usualWords(site));
    box->setProperty("unset", name.isEmpty());
    if (box->findText(name) < 0 && !name.isEmpty()) box->addItem(name);
    box->setCurrentIndex(name.isEmpty() && site.optional ? 0 : box->findText(name));
    if (isLong(name, *box)) box->setToolTip(name);
    QObject::connect(box, &QComboBox::activated, box, [box, site, commit, name](int index) {
      const QString chosen = site.optional && index == 0 ? QString() : box->itemText(index);
      if (chosen != name) commit(chosen);
    });
    return box;
  }
  box->setEditable(true);
  box->setInsertPolicy(QComboBox::NoInsert);
  box->setEditText(name);
  box->lineEdit()->setPlaceholderText(site.absent());
  showWhole(*box->lineEdit());
  const auto changed = [box, commit, name] {
    if (box->currentText() != name) commit(box->currentText());
  };
  QObject::connect(box, &QComboBox::activated, box, changed);
  QObject::connect(box->lineEdit(), &QLineEdit::editingFinished, box, changed);
  return box;
}

}  // namespace talus
