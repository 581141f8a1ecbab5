#include "document/names.hpp"

#include <QObject>
#include <algorithm>

#include "model/quantity.hpp"

namespace talus::names {

namespace {

bool contains(const std::vector<std::string>& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

std::vector<std::string> listsNamedBy(const Json& rule) { return rule.value("names", std::vector<std::string>{}); }

std::vector<std::string> namesIn(const Json& list) {
  std::vector<std::string> names;
  for (const auto& [key, thing] : list.items()) {
    if (list.is_object()) names.push_back(key);
    if (list.is_array() && thing.contains("name")) names.push_back(thing.at("name"));
  }
  return names;
}

/// Where in `text` the name ends that it begins with, by its rule; nothing when it names something else.
bool namesThing(const std::string& text, const Json& rule, const std::string& name) {
  if (rule.value("quantity", false)) {
    const auto quantity = parse_quantity(text);
    return quantity && namesThing(quantity->of, {{"pieces", rule.value("pieces", false)}}, name);
  }
  if (text == name) return true;
  return rule.value("pieces", false) && text.starts_with(name + ".") && text.size() > name.size() + 1 &&
         text.find_first_not_of("0123456789", name.size() + 1) == std::string::npos;
}

/// A key of an object, or a text, that names a thing.
struct Reference {
  Place place;
  bool isKey = false;
};

void collect(const Json& value, const Json& rule, const Place& place, const std::string& list, const std::string& name,
             std::vector<Reference>& found) {
  const bool names = contains(listsNamedBy(rule), list);
  if (value.is_string()) {
    if (names && namesThing(value.get<std::string>(), rule, name)) found.push_back(Reference{place, false});
    return;
  }
  if (!value.is_structured() || schema::kindOf(rule) == schema::Kind::table) return;
  for (const auto& [key, member] : value.items()) {
    const Place inside = value.is_array() ? place / std::stoul(key) : place / key;
    if (value.is_object() && names && key == name) found.push_back(Reference{inside, true});
    const Json memberRule = schema::memberRule(rule, key);
    if (!memberRule.is_null()) collect(member, memberRule, inside, list, name, found);
  }
}

std::vector<Reference> referencesTo(const std::string& list, const std::string& name, const Json& project) {
  std::vector<Reference> found;
  collect(project, schema::root(), Place(), list, name, found);
  return found;
}

/// The same object with one key called otherwise, in its place.
void renameKey(Json& object, const std::string& from, const std::string& to) {
  Json renamed = Json::object();
  for (const auto& [key, value] : object.items()) renamed[key == from ? to : key] = value;
  object = std::move(renamed);
}

}  // namespace

std::vector<std::string> thatMayStand(const Json& rule, const Json& project) {
  std::vector<std::string> names;
  for (const auto& list : listsNamedBy(rule))
    if (project.contains(list))
      for (const auto& name : namesIn(project.at(list)))
        if (!contains(names, name)) names.push_back(name);
  return names;
}

std::vector<std::string> listsBeside(const std::string& list) {
  const Json& lists = schema::root().at("properties");
  return lists.contains(list) ? lists.at(list).value("sharesNames", std::vector<std::string>{list})
                              : std::vector<std::string>{list};
}

std::string fresh(const std::string& stem, const std::vector<std::string>& lists, const Json& project) {
  std::vector<std::string> taken;
  for (const auto& list : lists)
    if (project.contains(list)) std::ranges::copy(namesIn(project.at(list)), std::back_inserter(taken));
  for (int number = 1;; ++number) {
    const std::string name = stem + " " + std::to_string(number);
    if (!contains(taken, name)) return name;
  }
}

std::vector<Place> usesOf(const std::string& list, const std::string& name, const Json& project) {
  std::vector<Place> places;
  for (const auto& reference : referencesTo(list, name, project)) places.push_back(reference.place);
  return places;
}

void follow(Json& project, const std::string& list, const std::string& from, const std::string& to) {
  for (const auto& [place, isKey] : referencesTo(list, from, project)) {
    if (isKey)
      renameKey(project.at(place.parent_pointer()), from, to);
    else
      project.at(place) = to + project.at(place).get<std::string>().substr(from.size());
  }
}

void rename(Json& project, const Place& thing, const std::string& to) {
  const std::string list = Place(thing.parent_pointer()).back();
  Json& things = project.at(thing.parent_pointer());
  const std::string from =
      things.is_object() ? thing.back() : things.at(std::stoul(thing.back())).at("name").get<std::string>();
  follow(project, list, from, to);
  if (things.is_object())
    renameKey(things, from, to);
  else
    things.at(std::stoul(thing.back()))["name"] = to;
}

QString described(const Place& place, const Json& project) {
  const Place parent = place.parent_pointer();
  if (place.empty() || parent.empty()) {
    const Json rule = schema::ruleOf(place);
    return QString::fromStdString(rule.value("title", std::string("project"))).toLower();
  }
  const Json holder = schema::ruleOf(parent);
  const schema::Kind kind = schema::kindOf(holder);
  if (kind != schema::Kind::list && kind != schema::Kind::named) return described(parent, project);
  const QString title = QString::fromStdString(schema::ruleOf(place).value("title", std::string())).toLower();
  QString name = QString::fromStdString(place.back());
  if (kind == schema::Kind::list) {
    name = QString::number(std::stoi(place.back()) + 1);
    if (project.contains(place) && project.at(place).is_object() && project.at(place).contains("name"))
      name = QString::fromStdString(project.at(place).at("name").get<std::string>());
  }
  const QString own = title + u' ' + name;
  return parent.parent_pointer().empty() ? own : own + QObject::tr(" of %1").arg(described(parent, project));
}

}  // namespace talus::names
