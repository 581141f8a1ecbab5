#include "widgets/forms/typical_strengths.hpp"

#include <QComboBox>
#include <QFile>
#include <QStandardItemModel>

#include "document/document.hpp"
#include "document/names.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr const char* keys[] = {"friction_angle", "residual_friction_angle", "cohesion"};

const schema::Json& strengths() {
  static const schema::Json read = [] {
    QFile file(QStringLiteral(":/presets/joint_strengths.json"));
    file.open(QIODevice::ReadOnly);
    return schema::Json::parse(file.readAll().toStdString());
  }();
  return read;
}

/// The joint has exactly these values.
bool agrees(const schema::Json& joint, const schema::Json& strength) {
  for (const char* key : keys)
    if (joint.value(key, schema::Json()) != strength.value(key, schema::Json())) return false;
  return true;
}

void addHeading(QComboBox& box, const QString& words) {
  box.addItem(words);
  auto* item = static_cast<QStandardItemModel*>(box.model())->item(box.count() - 1);
  item->setFlags(Qt::NoItemFlags);
}

}  // namespace

TypicalStrengths::TypicalStrengths(const FieldSite& joint) : FormField(joint) {
  auto* box = makeCombo({}, tr("Typical strength"));
  box->setObjectName(text(site().place.to_string()) + QStringLiteral("#typical"));
  box->addItem(tr("own values"));
  QString source = tr("Values that others have measured, to begin with");
  for (const Json& group : strengths().at("groups")) {
    const QString from = text(group.at("source").get<std::string>());
    addHeading(*box, text(group.at("name").get<std::string>()));
    for (const Json& strength : group.at("joints")) {
      const QString measured = text(strength.at("measured").get<std::string>());
      box->addItem(text(strength.at("name").get<std::string>()), QString::fromStdString(strength.dump()));
      const QString tip = tr("typical; measured: %1\n%2").arg(measured, from);
      box->setItemData(box->count() - 1, tip, Qt::ToolTipRole);
      if (!site().isSet() || !agrees(*site().value(), strength)) continue;
      box->setCurrentIndex(box->count() - 1);
      source = tip;
    }
  }
  box->setToolTip(source);
  connect(box, &QComboBox::activated, this, [this, box](int chosen) {
    const QByteArray strength = box->itemData(chosen).toString().toUtf8();
    if (!strength.isEmpty()) choose(Json::parse(strength.toStdString()));
  });
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  setMargins(layout, 0, 8);
  auto* title = makeLabel(tr("Typical"), "muted");
  title->setFixedWidth(title_width);
  title->setToolTip(source);
  layout->addWidget(title);
  layout->addWidget(box, 1);
  add(row);
}

void TypicalStrengths::choose(const Json& strength) {
  const QString name = text(strength.at("name").get<std::string>());
  const QString what = tr("use %1 for %2").arg(name, names::described(site().place, site().context.document.json()));
  change(what, [&](Json& project) {
    Json& joint = project.at(site().place);
    for (const char* key : keys) {
      if (strength.contains(key))
        joint[key] = strength.at(key);
      else
        joint.erase(key);
    }
  });
}

}  // namespace talus
