#include "document/names.hpp"

#include <QObject>
#include <algorithm>
#include <set>

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

using NewNames = std::map<std::string, std::string>;

/// Which of some names a text has, by its rule: a key of `names`, or its end.
NewNames::const_iterator namedBy(const std::string& text, const Json& rule, const NewNames& names) {
  std::string thing = text;
  if (rule.value("quantity", false)) {
    const auto quantity = parse_quantity(text);
    if (!quantity) return names.end();
    thing = quantity->of;
  }
  if (const auto found = names.find(thing); found != names.end()) return found;
  const auto dot = thing.rfind('.');
  const bool isPiece = rule.value("pieces", false) && dot != std::string::npos && dot + 1 < thing.size() &&
                       thing.find_first_not_of("0123456789", dot + 1) == std::string::npos;
  return isPiece ? names.find(thing.substr(0, dot)) : names.end();
}

/// A key of an object, or a text, that names a thing.
struct Reference {
  Place place;
  bool isKey = false;
  std::string name;
};

/// Finds the references to things of a list that have some names.
class Search {
 public:
  Search(const std::string& list, const NewNames& names) : list_(list), names_(names) {}

  std::vector<Reference> in(const Json& project) {
    found_.clear();
    look(project, schema::root(), Place());
    return std::move(found_);
  }

 private:
  void look(const Json& value, const Json& rule, const Place& place) {
    const bool mayName = contains(listsNamedBy(rule), list_);
    if (value.is_string()) {
      if (!mayName) return;
      const auto named = namedBy(value.get<std::string>(), rule, names_);
      if (named != names_.end()) found_.push_back({place, false, named->first});
      return;
    }
    if (!value.is_structured() || schema::kindOf(rule) == schema::Kind::table) return;
    const bool isList = value.is_array();
    for (const auto& [key, member] : value.items()) {
      if (!member.is_string() && !member.is_structured()) continue;
      const Place inside = isList ? place / std::stoul(key) : place / key;
      if (!isList && mayName && names_.contains(key)) found_.push_back({inside, true, key});
      const Json& within = memberRule(rule, isList ? std::string() : key);
      if (!within.is_null()) look(member, within, inside);
    }
  }

  /// Of a rule that stands in the schema or was told here: things of one list have the same.
  const Json& memberRule(const Json& rule, const std::string& key) {
    const auto [known, isNew] = rules_.try_emplace({&rule, key});
    if (isNew) known->second = schema::memberRule(rule, key);
    return known->second;
  }

  const std::string& list_;
  const NewNames& names_;
  std::map<std::pair<const Json*, std::string>, Json> rules_;
  std::vector<Reference> found_;
};

std::vector<Reference> referencesTo(const std::string& list, const NewNames& names, const Json& project) {
  return Search(list, names).in(project);
}

/// The same object with some keys called otherwise, in their places.
void renameKeys(Json& object, const NewNames& names) {
  Json renamed = Json::object();
  for (const auto& [key, value] : object.items()) renamed[names.contains(key) ? names.at(key) : key] = value;
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
  for (const auto& reference : referencesTo(list, {{name, name}}, project)) places.push_back(reference.place);
  return places;
}

void follow(Json& project, const std::string& list, const std::map<std::string, std::string>& names) {
  std::set<Place> objects;  // whose keys are names
  for (const auto& [place, isKey, name] : referencesTo(list, names, project)) {
    if (isKey)
      objects.insert(place.parent_pointer());
    else
      project.at(place) = names.at(name) + project.at(place).get<std::string>().substr(name.size());
  }
  for (const Place& place : objects) renameKeys(project.at(place), names);
}

void rename(Json& project, const Place& thing, const std::string& to) {
  const std::string list = Place(thing.parent_pointer()).back();
  Json& things = project.at(thing.parent_pointer());
  const std::string from =
      things.is_object() ? thing.back() : things.at(std::stoul(thing.back())).at("name").get<std::string>();
  follow(project, list, {{from, to}});
  if (things.is_object())
    renameKeys(things, {{from, to}});
  else
    things.at(std::stoul(thing.back()))["name"] = to;
}

QString described(const Place& place, const Json& project) {
  const Place parent = place.parent_pointer();
  if (place.empty() || parent.empty()) {
    const QString title = schema::words(schema::ruleOf(place), "title");
    return schema::withinSentence(title.isEmpty() ? QObject::tr("project") : title);
  }
  const Json holder = schema::ruleOf(parent);
  const schema::Kind kind = schema::kindOf(holder);
  if (kind != schema::Kind::list && kind != schema::Kind::named) return described(parent, project);
  const QString title = schema::withinSentence(schema::words(schema::ruleOf(place), "title"));
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
