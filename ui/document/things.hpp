#pragma once

#include "document/document.hpp"

/// Things of the project as they are made, copied, moved and taken away in tree and tables: one step each that can be
/// undone, and the thing is selected afterwards. Each throws InputError, and changes nothing, where the project would
/// be impossible.
namespace talus::things {

void add(Document& document, Item::Kind kind);
void duplicate(Document& document, const Item& thing);
/// Refused while something names it: the error says what.
void remove(Document& document, const Item& thing);
void move(Document& document, const Item& thing, int by);
/// It is one of several in a list, that can be copied and taken away.
bool isListed(Item::Kind kind);

/// "Material", as the schema calls one of a kind.
QString titleOf(Item::Kind kind);

}  // namespace talus::things
