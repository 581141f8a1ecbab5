#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace talus {

/// What a checkpoint is of.
struct CheckpointLabel {
  std::string version;       ///< of the program that wrote it: only that one reads the state
  std::string project_text;  ///< of the project file
  double time = 0;           ///< s
};

/// checkpoint.h5 of a results folder: all that a run needs to go on from some moment with the same bits.
struct Checkpoint {
  CheckpointLabel label;
  std::string state;  ///< bytes of a StateArchive
};

/// Gives the bytes of a state, piece by piece, to who writes them.
using StateSource = std::function<void(const std::function<void(std::string_view)>&)>;

/// Writes the file whole or not at all, and has it on the disk before the old one goes. Holds one piece of the state at
/// a time. Throws WriteError.
void write_checkpoint(const std::filesystem::path& file, const CheckpointLabel& label, const StateSource& state);

/// None where there is no file. Throws InputError where it is none of ours or damaged.
std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& file);
std::optional<CheckpointLabel> read_checkpoint_label(const std::filesystem::path& file);

}  // namespace talus
