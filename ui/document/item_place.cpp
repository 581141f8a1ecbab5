#include "document/item_place.hpp"

#include <iterator>
#include <string>
#include <vector>

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

const Json* listOf(Item::Kind kind, const Json& project) {
  const char* key = listKey(kind);
  if (!key || !project.contains(key)) return nullptr;
  return &project.at(key);
}

}  // namespace

bool isOneThing(Item::Kind kind) {
  return kind == Item::Kind::none || kind == Item::Kind::solver || kind == Item::Kind::output ||
         kind == Item::Kind::splinters || kind == Item::Kind::mesh;
}

const char* listKey(Item::Kind kind) {
  switch (kind) {
    case Item::Kind::none:
      return "";
    case Item::Kind::solid:
      return "solids";
    case Item::Kind::cut:
      return "cuts";
    case Item::Kind::joint:
      return "joints";
    case Item::Kind::blockWish:
      return "blocks";
    case Item::Kind::merge:
      return "merges";
    case Item::Kind::splinters:
      return "splinters";
    case Item::Kind::mesh:
      return "mesh";
    case Item::Kind::interface:
      return "interfaces";
    case Item::Kind::material:
      return "materials";
    case Item::Kind::load:
      return "loads";
    case Item::Kind::constraint:
      return "constraints";
    case Item::Kind::velocity:
      return "velocities";
    case Item::Kind::inSitu:
      return "in_situ";
    case Item::Kind::stage:
      return "stages";
    case Item::Kind::monitor:
      return "monitors";
    case Item::Kind::expectation:
      return "expect";
    case Item::Kind::solver:
      return "solver";
    case Item::Kind::output:
      return "output";
    case Item::Kind::block:
      break;
  }
  return nullptr;
}

Json::json_pointer placeOf(const Item& item, const Json& project) {
  Json::json_pointer place;
  const char* key = listKey(item.kind);
  if (!key || !*key) return place;
  place /= std::string(key);
  if (isOneThing(item.kind)) return place;
  const Json* list = listOf(item.kind, project);
  if (list && list->is_object()) return place / std::next(list->begin(), item.index).key();
  return place / static_cast<std::size_t>(item.index);
}

Item itemAt(const Json::json_pointer& place, const Json& project) {
  std::vector<std::string> keys;
  for (Json::json_pointer rest = place; !rest.empty(); rest = rest.parent_pointer())
    keys.insert(keys.begin(), rest.back());
  if (keys.empty()) return {};
  for (int number = 0; number <= static_cast<int>(Item::Kind::output); ++number) {
    const auto kind = static_cast<Item::Kind>(number);
    if (!listKey(kind) || listKey(kind) != keys[0]) continue;
    if (isOneThing(kind)) return {kind, 0};
    const Json* list = listOf(kind, project);
    if (keys.size() < 2 || !list) return {};
    const bool isNumber = keys[1].find_first_not_of("0123456789") == std::string::npos;
    if (list->is_array() && !isNumber) return {};
    const Item item{kind, list->is_array() ? std::stoi(keys[1])
                                           : static_cast<int>(std::distance(list->begin(), list->find(keys[1])))};
    return exists(item, project) ? item : Item{};
  }
  return {};
}

bool exists(const Item& item, const Json& project) {
  if (isOneThing(item.kind) || !listKey(item.kind)) return true;
  const Json* list = listOf(item.kind, project);
  return list && item.index >= 0 && item.index < static_cast<int>(list->size());
}

}  // namespace talus
