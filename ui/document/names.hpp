#pragma once

#include <QStringList>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "document/schema.hpp"

/// Names in a project, and who names whom: as the schema says it.
namespace talus::names {

using schema::Json;
using schema::Place;

/// The names that a text with this rule may be: those of all things in the lists that it names.
std::vector<std::string> thatMayStand(const Json& rule, const Json& project);
/// `stem` with the first number that no thing of these lists has: "material 2".
std::string fresh(const std::string& stem, const std::vector<std::string>& lists, const Json& project);
/// Lists that share their names with this one: blocks are called after solids.
std::vector<std::string> listsBeside(const std::string& list);

/// The places that name the thing `name` of a list.
std::vector<Place> usesOf(const std::string& list, const std::string& name, const Json& project);
/// All that name a thing of a list that is a key of `names` name it by the value from now on; all at once, so that two
/// may change their names.
void follow(Json& project, const std::string& list, const std::map<std::string, std::string>& names);
/// The thing at a place of a list gets another name, and all that name it follow.
void rename(Json& project, const Place& thing, const std::string& to);

/// "material rock", "cut 3", "joint J1 of stage settle": what a place belongs to, for people.
QString described(const Place& place, const Json& project);

}  // namespace talus::names
