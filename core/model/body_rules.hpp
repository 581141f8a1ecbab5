#pragma once

#include <functional>
#include <optional>
#include <string>

#include "model/project.hpp"

namespace talus {

/// What a block was built as, by its name; nothing where that is not known (yet).
using BodyOfBlock = std::function<std::optional<BodyKind>(const std::string&)>;

/// The rules that ask what a block was built as: only a fixed one is moved as a whole, and only one that may move can
/// be held by a stage and let go again. Throws InputError for the first that is broken by a block that is known.
void check_bodies(const Project& project, const BodyOfBlock& body_of);

/// What the project alone says: nothing for an override that leaves the body to its solid, when solids differ.
std::optional<BodyKind> body_before_cutting(const Project& project, const std::string& block);

}  // namespace talus
