#pragma once

#include <QTemporaryDir>
#include <algorithm>
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
  /// it. What was made of the same project under the same settings before is taken from there.
  void study(const std::filesystem::path& file,
             const LadderWish& wish = parse_ladder_wish({}, {"time_step=4,2,1,0.5"})) {
    const StudyFolder made(std::filesystem::path(file).replace_extension(".accuracy"),
                           make_plan({file, false, wish, "test"}), false);
    static const QTemporaryDir kept;
    static std::vector<std::pair<std::string, std::vector<Setting>>> known;  // projects and settings of what is kept
    const auto wanted = std::make_pair(made.plan().project_text, made.plan().ladder.settings);
    const auto index = std::ranges::find(known, wanted) - known.begin();
    const std::filesystem::path runs = kept.filePath(QString::number(index)).toStdString();
    if (index < std::ssize(known)) {
      std::filesystem::copy(
          runs, made.path() / "runs",
          std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
      EXPECT_TRUE(made.missing_runs().empty());
    } else {
      NoProgress nobody;
      for (const int run : made.missing_runs()) perform_study_run(made, run, nobody);
      std::filesystem::copy(made.path() / "runs", runs, std::filesystem::copy_options::recursive);
      known.push_back(wanted);
    }
    replace_whole_file(made.path() / "accuracy.json", accuracy_json(evaluate(made, std::nullopt)));
  }
};

}  // namespace talus
