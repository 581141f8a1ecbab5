#pragma once

#include <functional>
#include <optional>
#include <string>

#include "model/project.hpp"

namespace talus {

/// What a block was built as. `automatic` before cutting, where that is yet to be chosen.
struct KnownBody {
  BodyKind body = BodyKind::tetrahedra;
  bool chosen = false;  ///< the project leaves it open: 'auto'
};

/// Of a block by its name; nothing where that is not known (yet).
using BodyOfBlock = std::function<std::optional<KnownBody>(const std::string&)>;

/// The rules that ask what a block was built as: only a fixed one is moved as a whole, only one that may move can be
/// held by a stage and let go again, and only one that deforms has stress to monitor. Throws InputError for the first
/// that is broken by a block that is known.
void check_bodies(const Project& project, const BodyOfBlock& body_of);

/// What the project alone says: nothing for an override that leaves the body to its solid, when solids differ.
std::optional<KnownBody> body_before_cutting(const Project& project, const std::string& block);

}  // namespace talus
