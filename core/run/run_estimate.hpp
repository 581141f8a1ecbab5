#pragma once

#include <filesystem>

#include "model/project.hpp"

namespace talus {

struct BlockSystem;

/// What a run will come to, before its first step.
struct RunEstimate {
  double memory = 0;   ///< bytes that solving holds at most, beside the blocks; within a third
  double frames = 0;   ///< at least
  double results = 0;  ///< bytes of the results folder: frames, without their contacts, and a line a step; at least
};
RunEstimate run_estimate(const Project& project, const BlockSystem& system);

/// Throws InputError where solving takes more memory than there is, or the results are larger than what is free on the
/// disk of `folder`, where they are to be, with what earlier results there give back.
void require_room(const RunEstimate& estimate, const std::filesystem::path& folder);

}  // namespace talus
