#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace talus {

struct BlockSystem;
struct Project;

}  // namespace talus

namespace talus::cli {

/// What cutting did beside blocks: splinters that were dropped or merged, rock that was excavated, joints that end
/// inside a block. Lines for a reader, empty where there is nothing to tell.
std::string cutting_report_text(const Project& project, const BlockSystem& system);

/// The same: "splinters", "excavated_volume" and "ending_joints".
nlohmann::ordered_json cutting_report_json(const Project& project, const BlockSystem& system);

}  // namespace talus::cli
