#pragma once

#include <fstream>

#include "driven_window.hpp"
#include "io/whole_file.hpp"
#include "study/accuracy/accuracy_files.hpp"
#include "study/accuracy/study_record.hpp"

namespace talus {

/// A window with the sliding cube, of which a study can be made.
class StudiedWindow : public DrivenWindow {
 protected:
  /// Solves the project under the ladder that is wished, else at four lengths of its step, and leaves the study beside
  /// it.
  void study(const std::filesystem::path& file,
             const LadderWish& wish = parse_ladder_wish({}, {"time_step=4,2,1,0.5"})) {
    const StudyFolder made(std::filesystem::path(file).replace_extension(".accuracy"),
                           make_plan({file, false, wish, "test"}), false);
    NoProgress nobody;
    for (const int run : made.missing_runs()) perform_study_run(made, run, nobody);
    replace_whole_file(made.path() / "accuracy.json", accuracy_json(evaluate(made, std::nullopt)));
  }
};

}  // namespace talus
