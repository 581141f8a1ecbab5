#pragma once

#include <filesystem>

#include "base/progress.hpp"
#include "results/result_folder.hpp"

namespace talus {

/// Writes every frame as frame_00000.vtu … and frames.pvd, the collection in time that ParaView opens: the moved mesh
/// with displacement, velocity, stress, von Mises stress, block and material. Binary, with 64-bit headers.
/// The folder is made; it must be empty. Throws InputError when it is not or cannot be written, Cancelled.
void export_vtu(const ResultReader& results, const std::filesystem::path& folder, Progress& progress);

/// Writes blocks.csv, history.csv, steps.csv, frames.csv (times) and for every frame nodes_00000.csv …,
/// tetrahedra_00000.csv …, contacts_00000.csv … and motions_00000.csv …, how blocks move; headers name the units,
/// numbers read back exactly. The folder is made; it must be empty. Throws InputError when it is not or cannot be
/// written, Cancelled.
void export_csv(const ResultReader& results, const std::filesystem::path& folder, Progress& progress);

}  // namespace talus
