#pragma once

#include <string>

namespace talus {

struct BlockSystem;

}  // namespace talus

namespace talus::cli {

/// What blocks of body 'auto' were built as and why, blocks of one reason together, in lines of at most 100 characters;
/// empty where the project says every body.
std::string chosen_bodies_text(const BlockSystem& system);

}  // namespace talus::cli
