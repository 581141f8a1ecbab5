#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "study/accuracy/ladder.hpp"
#include "study/accuracy/study_measure.hpp"
#include "study/runs/runs_folder.hpp"

namespace talus {

/// All that the runs of a study need to know, and by which a study that was stopped is told from another one.
struct StudyPlan {
  std::string program;                 ///< its version: another one may compute other numbers
  std::filesystem::path project_file;  ///< absolute
  bool allow_outside = false;          ///< the project may name files outside its folder
  std::string project_text;            ///< as it was when the study began
  std::string fingerprint;             ///< of the text and of the files that it names
  Ladder ladder;
  int repeats = 1;  ///< how often each setting is run: the first time as it is, then hardly changed (perturbation.hpp)
  std::optional<StudyMeasure> measure{};  ///< empty: `expect` lines where there are some, else displacements

  /// Runs are numbered from 0: all settings once, then all of them again.
  int runs() const { return static_cast<int>(ladder.settings.size()) * repeats; }
  int run_of(int setting, int repeat) const { return setting + repeat * static_cast<int>(ladder.settings.size()); }
  const Setting& setting_of(int run) const {
    return ladder.settings[static_cast<std::size_t>(run) % ladder.settings.size()];
  }
  int repeat_of(int run) const { return run / static_cast<int>(ladder.settings.size()); }
};

struct StudyRequest {
  std::filesystem::path project_file;
  bool allow_outside = false;
  LadderWish wish;
  std::string program;
  int repeats = 1;
  std::optional<StudyMeasure> measure{};
};

/// Reads the project and makes its ladder. Throws InputError for a faulty project or wish.
StudyPlan make_plan(const StudyRequest& request);

/// The project of a plan. Throws InputError as `parse_project` does.
Project project_of(const StudyPlan& plan);

/// The plan's text changed to say this project. Throws InputError when a number is not finite.
std::string text_of(const Project& project, const StudyPlan& plan);

/// A study with its plan.
class StudyFolder final : public RunsFolder {
 public:
  /// Begins the study in an empty or new folder, or goes on with it where the plan is the same. Throws InputError where
  /// the folder holds another study or something else; with `restart` another study's files go. There may be more
  /// repeats than before, and what is measured may be another thing: the runs know all of it.
  StudyFolder(const std::filesystem::path& folder, const StudyPlan& plan, bool restart);
  /// A study that was begun. Throws InputError where there is none.
  explicit StudyFolder(const std::filesystem::path& folder);

  const StudyPlan& plan() const { return plan_; }

 private:
  StudyFolder(const std::filesystem::path& folder, StudyPlan plan);

  StudyPlan plan_;
};

}  // namespace talus
