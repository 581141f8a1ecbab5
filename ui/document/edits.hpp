#pragma once

#include <string>

#include "base/vector.hpp"
#include "document/schema.hpp"

/// Changes of a project, said key by key; none is checked here. What stands in the project afterwards is handed to
/// Document::change.
namespace talus::edits {

using schema::Json;
using schema::Place;

/// What a thing, or a field, is given when it is made: what the schema has as its example or default, with a name that
/// is not taken and the first of the names that it may refer to.
Json startOf(const Json& rule, const Json& project);

/// A point [m] as the project keeps it: to the micrometre. A hand is no finer, and digits of rounding say nothing.
Vec3 keptPlace(const Vec3& point);
Json placeJson(const Vec3& point);

/// Sets what stands at a place, and what must be there with it.
void set(Json& project, const Place& place, const Json& value);
/// Takes it away, and what is nothing without it.
void clear(Json& project, const Place& place);
/// An object that has exactly one of some keys has this one from now on.
void setVariant(Json& project, const Place& object, const std::string& key);

/// Each says where the thing is afterwards.
Place add(Json& project, const Place& list);
Place duplicate(Json& project, const Place& thing);
/// By so many places down the list; it stays within it.
Place move(Json& project, const Place& thing, int by);
void remove(Json& project, const Place& thing);

}  // namespace talus::edits
