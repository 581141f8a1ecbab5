#include "document/things.hpp"

#include <QStringList>

#include "base/error.hpp"
#include "document/edits.hpp"
#include "document/item_place.hpp"
#include "document/names.hpp"

namespace talus::things {

namespace {

using schema::Json;
using schema::Place;

Place listOf(Item::Kind kind) { return Place() / std::string(listKey(kind)); }

void change(Document& document, const QString& what, const auto& edit) {
  Json project = document.json();
  const Place place = edit(project);
  document.change(project, what);
  document.selection().select(itemAt(place, document.json()));
}

QString nameAt(const Place& place, const Json& project) { return names::described(place, project); }

void refuseWhileNamed(const Place& place, const Json& project) {
  const Json& list = project.at(place.parent_pointer());
  const Json& thing = project.at(place);
  if (list.is_array() && !thing.contains("name")) return;
  const std::string name = list.is_object() ? place.back() : thing.at("name").get<std::string>();
  const auto uses = names::usesOf(Place(place.parent_pointer()).back(), name, project);
  if (uses.empty()) return;
  constexpr std::size_t most = 4;
  QStringList users;
  for (std::size_t i = 0; i < uses.size() && i < most; ++i) users << nameAt(uses[i], project);
  users.removeDuplicates();
  if (uses.size() > most) users << QObject::tr("%1 more").arg(uses.size() - most);
  throw InputError(
      place.to_string(),
      QObject::tr("%1 is used by %2").arg(nameAt(place, project), users.join(QStringLiteral(", "))).toStdString(),
      QObject::tr("let them use another one first").toStdString());
}

}  // namespace

bool isListed(Item::Kind kind) {
  const char* key = listKey(kind);
  return key && *key && !isOneThing(kind);
}

QString titleOf(Item::Kind kind) {
  return schema::words(schema::memberRule(schema::ruleOf(listOf(kind)), {}), "title");
}

void add(Document& document, Item::Kind kind) {
  change(document, QObject::tr("add %1").arg(schema::withinSentence(titleOf(kind))), [&](Json& project) {
    const bool first = !project.contains(listKey(kind)) || project.at(listKey(kind)).empty();
    const Place place = edits::add(project, listOf(kind));
    // Contacts on no cut need a joint as soon as there are joints.
    if (kind == Item::Kind::joint && first && !project.contains("default_joint"))
      edits::set(project, Place("/default_joint"), place.back());
    return place;
  });
}

void duplicate(Document& document, const Item& thing) {
  const Place place = placeOf(thing, document.json());
  change(document, QObject::tr("duplicate %1").arg(nameAt(place, document.json())),
         [&](Json& project) { return edits::duplicate(project, place); });
}

void move(Document& document, const Item& thing, int by) {
  const Place place = placeOf(thing, document.json());
  change(document, QObject::tr("move %1").arg(nameAt(place, document.json())),
         [&](Json& project) { return edits::move(project, place, by); });
}

void remove(Document& document, const Item& thing) {
  Json project = document.json();
  const Place place = placeOf(thing, project);
  refuseWhileNamed(place, project);
  const QString what = QObject::tr("delete %1").arg(nameAt(place, project));
  edits::remove(project, place);
  document.change(project, what);
  document.selection().clear();
}

}  // namespace talus::things
