#pragma once

#include <string>

namespace talus {

/// What `--version` says of a program, in lines: "talus 0.1.0", the commit that it was built from where that is known,
/// and the libraries with which it was built. The last line is not ended.
std::string version_text(const std::string& program);

}  // namespace talus
