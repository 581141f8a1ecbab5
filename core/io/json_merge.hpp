#pragma once

#include <string>

#include "io/json_text.hpp"

namespace talus {

/// A text whose value is changed from `before` to `after`, with everything else left as the author wrote it: comments,
/// spelling of numbers, order of keys, blank lines, defaults that are written out or left out.
///
/// `before` is what `old` means with all defaults filled in, `after` the same of what is to be written. Where both
/// agree the old text stands, byte for byte. A comment belongs to the value it precedes, or to the one before it on
/// the same line, and goes when that value goes. Things in lists are recognised by their name, else by their place.
/// Throws InputError when a number is not finite.
std::string merge_json(const JsonText& old, const OrderedJson& before, const OrderedJson& after);

}  // namespace talus
