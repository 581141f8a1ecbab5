#pragma once

#include <optional>
#include <string>

namespace talus {

/// The place in a project's text, "stages/0/time_step", at which another one is not the project whose run could go on
/// as this one; none where its run can. The last stage may last longer, and stages may follow. Layout, comments and
/// defaults that are said do not count. Throws InputError as parse_project does.
std::optional<std::string> change_since_run(const std::string& text_of_run, const std::string& text_now);

}  // namespace talus
