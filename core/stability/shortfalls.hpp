#pragma once

#include <string>

namespace talus {

/// Why a scene of the suite is known not to hold yet; empty: it holds. Whoever mends a cause takes the names off: a
/// scene that holds although it stands here fails its test.
std::string known_shortfall(const std::string& name);

}  // namespace talus
