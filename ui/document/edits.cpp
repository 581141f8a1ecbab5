#include "document/edits.hpp"

#include <algorithm>

#include "document/names.hpp"

namespace talus::edits {

namespace {

using schema::Kind;

std::string stemOf(const Json& rule) {
  std::string stem = rule.value("title", std::string("thing"));
  if (!stem.empty() && stem[0] >= 'A' && stem[0] <= 'Z') stem[0] = static_cast<char>(stem[0] - 'A' + 'a');
  return stem;
}

Json startOfNumber(const Json& rule) {
  if (rule.contains("exclusiveMinimum") && rule.at("exclusiveMinimum") >= 0) return 1;
  return rule.contains("minimum") ? rule.at("minimum") : Json(0);
}

/// The `number`-th of the names that may stand here, so that a pair names two.
Json startOfText(const Json& rule, const Json& project, std::size_t number = 0) {
  const auto names = names::thatMayStand(rule, project);
  const std::string name = number < names.size() ? names[number] : std::string();
  return rule.value("quantity", false) ? name + ".displacement.magnitude" : name;
}

Json startOfObject(const Json& rule, const Json& project) {
  Json made = rule.contains("examples") ? rule.at("examples").at(0) : Json::object();
  const auto choices = schema::variants(rule);
  const bool chosen = std::ranges::any_of(choices, [&](const auto& key) { return made.contains(key); });
  if (!choices.empty() && !chosen) made[choices[0]] = startOf(schema::memberRule(rule, choices[0]), project);
  Json whole = Json::object();  // with the name first
  for (const auto& key : rule.value("required", Json::array())) {
    const auto name = key.get<std::string>();
    whole[name] = made.contains(name) ? made.at(name) : startOf(schema::memberRule(rule, name), project);
  }
  whole.update(made);
  return whole;
}

std::size_t indexOf(const Place& thing) { return std::stoul(thing.back()); }

Json::iterator at(Json& list, const Place& thing) {
  return list.is_object() ? list.find(thing.back()) : list.begin() + static_cast<std::ptrdiff_t>(indexOf(thing));
}

bool isNamed(const Json& rule) {
  return rule.contains("properties") && rule.at("properties").contains("name") &&
         schema::memberRule(rule, "name").value("identifies", false);
}

/// The same object with a member more, behind the `after`-th.
void insert(Json& object, std::size_t after, const std::string& key, const Json& value) {
  Json longer = Json::object();
  std::size_t place = 0;
  for (const auto& [other, member] : object.items()) {
    longer[other] = member;
    if (place++ == after) longer[key] = value;
  }
  object = std::move(longer);
}

}  // namespace

Json startOf(const Json& rule, const Json& project) {
  const Kind kind = schema::kindOf(rule);
  if (kind == Kind::object) return startOfObject(rule, project);
  if (rule.contains("examples")) return rule.at("examples").at(0);
  if (rule.contains("default")) return rule.at("default");
  Json made = Json::array();
  switch (kind) {
    case Kind::constant:
      return rule.at("const");
    case Kind::choice:
      return rule.at("enum").at(0);
    case Kind::boolean:
      return false;
    case Kind::number:
    case Kind::namedNumber:
      return startOfNumber(rule);
    case Kind::text:
      return startOfText(rule, project);
    case Kind::named:
      return Json::object();
    case Kind::numbers:
      for (std::size_t i = 0; i < rule.at("minItems"); ++i) made.push_back(0);
      return made;
    case Kind::texts:
      for (std::size_t i = 0; i < rule.at("minItems"); ++i)
        made.push_back(startOfText(schema::memberRule(rule, {}), project, i));
      return made;
    case Kind::list:
    case Kind::table:
      for (std::size_t i = 0; i < rule.value("minItems", std::size_t{0}); ++i)
        made.push_back(startOf(schema::memberRule(rule, {}), project));
      return made;
    case Kind::object:
      break;
  }
  return nullptr;
}

Vec3 keptPlace(const Vec3& point) { return (point * 1e6).array().round() / 1e6; }

Json placeJson(const Vec3& point) {
  const Vec3 kept = keptPlace(point);
  return {kept.x(), kept.y(), kept.z()};
}

void set(Json& project, const Place& place, const Json& value) {
  if (place.empty()) {
    project = value;
    return;
  }
  const Place holder = place.parent_pointer();
  if (!project.contains(holder)) set(project, holder, Json::object());
  project[place] = value;
  const Json rule = schema::ruleOf(holder);
  for (const auto& partner : schema::neededBy(rule, place.back()))
    if (!project.at(holder).contains(partner))
      project[holder][partner] = startOf(schema::memberRule(rule, partner), project);
}

void clear(Json& project, const Place& place) {
  const Place holder = place.parent_pointer();
  if (!project.contains(place)) return;
  project[holder].erase(place.back());
  for (const auto& other : schema::thatNeed(schema::ruleOf(holder), place.back())) clear(project, holder / other);
}

void setVariant(Json& project, const Place& object, const std::string& key) {
  const Json rule = schema::ruleOf(object);
  for (const auto& other : schema::variants(rule))
    if (other != key) clear(project, object / other);
  set(project, object / key, startOf(schema::memberRule(rule, key), project));
}

Place add(Json& project, const Place& list) {
  const Json rule = schema::ruleOf(list), thingRule = schema::memberRule(rule, {});
  const bool byName = schema::kindOf(rule) == Kind::named;
  if (!project.contains(list)) set(project, list, byName ? Json::object() : Json::array());
  Json thing = startOf(thingRule, project);
  const auto beside = names::listsBeside(list.back());
  if (byName) {
    // A map whose keys are names of other things begins with the first that it does not have.
    for (const auto& name : names::thatMayStand(rule, project))
      if (!project.at(list).contains(name)) return set(project, list / name, thing), list / name;
    const Place place = list / names::fresh(stemOf(thingRule), beside, project);
    set(project, place, thing);
    return place;
  }
  if (isNamed(thingRule)) thing["name"] = names::fresh(stemOf(thingRule), beside, project);
  if (thing.is_string())
    for (const auto& name : names::thatMayStand(thingRule, project))
      if (std::ranges::find(project.at(list), Json(name)) == project.at(list).end()) {
        thing = name;
        break;
      }
  project[list].push_back(thing);
  return list / (project.at(list).size() - 1);
}

Place duplicate(Json& project, const Place& thing) {
  const Place list = thing.parent_pointer();
  const Json rule = schema::ruleOf(thing);
  Json& things = project.at(list);
  const auto found = at(things, thing);
  Json copy = *found;
  const auto beside = names::listsBeside(list.back());
  if (things.is_object()) {
    const std::string name = names::fresh(thing.back(), beside, project);
    insert(things, static_cast<std::size_t>(std::distance(things.begin(), found)), name, copy);
    return list / name;
  }
  if (isNamed(rule)) copy["name"] = names::fresh(copy.at("name").get<std::string>(), beside, project);
  things.insert(things.begin() + static_cast<std::ptrdiff_t>(indexOf(thing)) + 1, copy);
  return list / (indexOf(thing) + 1);
}

Place move(Json& project, const Place& thing, int by) {
  const Place list = thing.parent_pointer();
  Json& things = project.at(list);
  const auto from = std::distance(things.begin(), at(things, thing));
  const auto to = std::clamp<std::ptrdiff_t>(from + by, 0, static_cast<std::ptrdiff_t>(things.size()) - 1);
  if (things.is_array()) {
    const Json moved = things.at(static_cast<std::size_t>(from));
    things.erase(things.begin() + from);
    things.insert(things.begin() + to, moved);
    return list / static_cast<std::size_t>(to);
  }
  std::vector<std::pair<std::string, Json>> members;
  for (const auto& [key, value] : things.items()) members.emplace_back(key, value);
  const auto moved = members[static_cast<std::size_t>(from)];
  members.erase(members.begin() + from);
  members.insert(members.begin() + to, moved);
  things = Json::object();
  for (const auto& [key, value] : members) things[key] = value;
  return thing;
}

void remove(Json& project, const Place& thing) {
  Json& list = project.at(thing.parent_pointer());
  list.erase(at(list, thing));
}

}  // namespace talus::edits
