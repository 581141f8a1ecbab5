#pragma once

#include <string>
#include <string_view>

namespace talus {

/// What the settings of a study are held to the finest by.
enum class StudyMeasure {
  displacement,  ///< of blocks and monitors at the quarters of every stage
  run_out,       ///< how far the block has gone horizontally that went farthest
  deposit,       ///< where the mass comes to lie: how far its centre has gone, and by how much its extent has grown
  start,         ///< when the first block sets off
  end,           ///< when the last one comes to rest
  stress,        ///< of the monitors that record it, at the quarters of every stage
};

constexpr std::string_view to_string(StudyMeasure measure) {
  constexpr std::string_view words[] = {"displacement", "run-out", "deposit", "start", "end", "stress"};
  return words[static_cast<int>(measure)];
}

/// "of the run-out", for titles.
std::string measure_text(StudyMeasure measure);

/// Throws InputError for another word than those above.
StudyMeasure study_measure_from(const std::string& word);

}  // namespace talus
