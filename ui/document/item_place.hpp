#pragma once

#include <nlohmann/json.hpp>

#include "document/selection.hpp"

namespace talus {

/// The key of the project file under which things of a kind stand: "solids"; "" for the project itself. Null for what
/// is in no file: a block as it was cut.
const char* listKey(Item::Kind kind);

/// There is one of the kind in a project, not a list: the solver's settings, the project itself.
bool isOneThing(Item::Kind kind);

/// Where a thing stands in the project: "/solids/2", "/materials/rock"; empty for nothing that is selected.
nlohmann::ordered_json::json_pointer placeOf(const Item& item, const nlohmann::ordered_json& project);

/// The thing that a place is, or is in: "/solids/2/box/min" is in the third solid. Nothing where it is in none.
Item itemAt(const nlohmann::ordered_json::json_pointer& place, const nlohmann::ordered_json& project);

/// The thing is in the project, or is none that a project file holds.
bool exists(const Item& item, const nlohmann::ordered_json& project);

}  // namespace talus
