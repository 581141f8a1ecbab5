#include "widgets/forms/list_field.hpp"

#include <QComboBox>
#include <QVBoxLayout>

#include "document/document.hpp"
#include "document/edits.hpp"
#include "document/names.hpp"
#include "widgets/forms/scalar_fields.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

ListField::ListField(const FieldSite& place, QWidget* parent) : FormField(place, parent) {
  const Json none = Json::array();
  const Json& things = site().isSet() ? *site().value() : none;
  for (const auto& [key, thing] : things.items()) {
    FieldSite entry = things.is_object() ? site().member(key) : site().element(std::stoul(key));
    entry.optional = false;
    add(makeEntry(entry));
  }
  const QString name = schema::words(schema::memberRule(site().rule, {}), "title");
  auto* more = makeAction(QStringLiteral("plus"), name.isEmpty() ? tr("Add") : name,
                          tr("Add one to %1").arg(schema::withinSentence(site().title())));
  more->setObjectName(text(site().place.to_string()) + QStringLiteral("#add"));
  connect(more, &QToolButton::clicked, this, [this] {
    change(tr("add to %1").arg(names::described(site().place, site().context.document.json())),
           [&](Json& project) { edits::add(project, site().place); });
  });
  add(more);
}

QWidget* ListField::makeEntry(const FieldSite& entry) {
  auto* whole = new QWidget(this);
  auto* column = new QVBoxLayout(whole);
  setMargins(column, 0, 2);
  auto* head = new QHBoxLayout;
  setMargins(head, 0, 4);
  auto* remove = makeTool(QStringLiteral("close"), tr("Take it away"));
  remove->setObjectName(text(entry.place.to_string()) + QStringLiteral("#remove"));
  connect(remove, &QToolButton::clicked, this, [this, place = entry.place] {
    change(tr("take %1 away").arg(names::described(place, site().context.document.json())),
           [&](Json& project) { edits::remove(project, place); });
  });
  const bool keyIsName = schema::kindOf(site().rule) == schema::Kind::named;
  if (isWide(entry.rule)) {
    const QString title = keyIsName ? text(entry.place.back()) : QString::number(std::stoi(entry.place.back()) + 1);
    head->addWidget(makeLabel(title, "strong"), 1);
    head->addWidget(remove);
    column->addLayout(head);
    column->addWidget(makeField(entry, whole));
  } else {
    head->addWidget(makeField(entry, whole), 1);
    head->addWidget(remove, 0, Qt::AlignTop);
    column->addLayout(head);
  }
  return whole;
}

}  // namespace talus
