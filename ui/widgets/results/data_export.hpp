#pragma once

#include <filesystem>
#include <functional>

#include "base/progress.hpp"

namespace talus {

/// What results can be handed over as, to be read by other programs.
enum class DataFormat { csv, vtu, stl, gltf };

/// Writes on the thread that it is called on. Throws InputError, Cancelled.
using Writing = std::function<void(Progress&)>;

/// Of a results folder: all frames as tables or as VTU, into an empty folder `to`; one frame's deposit as STL; the
/// slide as animated glTF.
Writing writingOfData(DataFormat format, const std::filesystem::path& results, int frame,
                      const std::filesystem::path& to);

/// All that a reader needs to believe the run of a results folder, as HTML or PDF.
Writing writingOfReport(const std::filesystem::path& results, const std::filesystem::path& to);

}  // namespace talus
