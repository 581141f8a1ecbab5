#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "results/result_folder.hpp"

/// What exports of many files have in common.
namespace talus {

/// Makes the folder. Throws InputError when it cannot be made or holds something.
void prepare_export_folder(const std::filesystem::path& folder);

/// "nodes_00012.csv"
std::string numbered_name(const std::string& name, int frame, const std::string& ending);

/// Throws InputError when the file cannot be written.
void write_export_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

/// Calls `write(frame)` for the frames of these numbers. Throws Cancelled.
void for_each_frame(const ResultReader& results, std::span<const int> numbers, Progress& progress,
                    const std::function<void(const Frame&)>& write);

/// 0, 1 … of all frames that the results hold.
std::vector<int> all_frames(const ResultReader& results);

}  // namespace talus
