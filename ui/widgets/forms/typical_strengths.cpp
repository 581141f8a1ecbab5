#include "widgets/forms/typical_strengths.hpp"

#include <QComboBox>
#include <QFile>
#include <QStandardItemModel>
#include <algorithm>

#include "document/document.hpp"
#include "document/names.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

const schema::Json& presets() {
  static const schema::Json read = [] {
    QFile file(QStringLiteral(":/presets/joint_strengths.json"));
    file.open(QIODevice::ReadOnly);
    return schema::Json::parse(file.readAll().toStdString());
  }();
  return read;
}

/// The joint has exactly these values.
bool agrees(const schema::Json& joint, const schema::Json& values, const std::vector<const char*>& keys) {
  return std::ranges::all_of(
      keys, [&](const char* key) { return joint.value(key, schema::Json()) == values.value(key, schema::Json()); });
}

void addHeading(QComboBox& box, const QString& words) {
  box.addItem(words);
  auto* item = static_cast<QStandardItemModel*>(box.model())->item(box.count() - 1);
  item->setFlags(Qt::NoItemFlags);
}

}  // namespace

TypicalStrengths::TypicalStrengths(const FieldSite& joint, QWidget* parent) : FormField(joint, parent) {
  auto* rows = new QWidget(this);
  auto* column = new QVBoxLayout(rows);
  setMargins(column, 0, 4);
  column->addWidget(makeChoice(tr("Typical"), tr("Typical strength"), "strengths",
                               {"friction_angle", "residual_friction_angle", "cohesion"}));
  column->addWidget(
      makeChoice(tr("Stiffness"), tr("Typical stiffness"), "stiffnesses", {"normal_stiffness", "shear_stiffness"}));
  add(rows);
}

QWidget* TypicalStrengths::makeChoice(const QString& title, const QString& name, const char* groups, const Keys& keys) {
  auto* box = makeCombo({}, name);
  box->setObjectName(text(site().place.to_string()) + u'#' + QLatin1String(groups));
  const bool isOpen =
      std::ranges::none_of(keys, [&](const char* key) { return site().isSet() && site().value()->contains(key); });
  box->addItem(isOpen ? tr("automatic") : tr("own values"));
  QString source = tr("Values that others have measured, to begin with");
  for (const Json& group : presets().at(groups)) {
    const QString from = text(group.at("source").get<std::string>());
    addHeading(*box, text(group.at("name").get<std::string>()));
    for (const Json& values : group.at("joints")) {
      box->addItem(text(values.at("name").get<std::string>()), QString::fromStdString(values.dump()));
      const QString tip = tr("typical; measured: %1\n%2").arg(text(values.at("measured").get<std::string>()), from);
      box->setItemData(box->count() - 1, tip, Qt::ToolTipRole);
      if (!site().isSet() || !agrees(*site().value(), values, keys)) continue;
      box->setCurrentIndex(box->count() - 1);
      source = tip;
    }
  }
  box->setToolTip(source);
  connect(box, &QComboBox::activated, this, [this, box, keys](int chosen) {
    const QByteArray values = box->itemData(chosen).toString().toUtf8();
    if (!values.isEmpty()) choose(Json::parse(values.toStdString()), keys);
  });
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  setMargins(layout, 0, 8);
  auto* label = makeLabel(title, "muted");
  label->setFixedWidth(title_width);
  label->setToolTip(source);
  layout->addWidget(label);
  layout->addWidget(box, 1);
  return row;
}

void TypicalStrengths::choose(const Json& values, const Keys& keys) {
  const QString name = text(values.at("name").get<std::string>());
  const QString what = tr("use %1 for %2").arg(name, names::described(site().place, site().context.document.json()));
  change(what, [&](Json& project) {
    Json& joint = project.at(site().place);
    for (const char* key : keys) {
      if (values.contains(key))
        joint[key] = values.at(key);
      else
        joint.erase(key);
    }
  });
}

}  // namespace talus
