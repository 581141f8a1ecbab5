#pragma once

#include <filesystem>

#include "jobs/results_loader.hpp"
#include "session/block_colouring.hpp"
#include "session/block_histories.hpp"
#include "session/block_survey.hpp"
#include "session/compared_results.hpp"
#include "session/current_project.hpp"
#include "session/current_run.hpp"
#include "session/display.hpp"
#include "session/drawn_joints.hpp"
#include "session/field_line.hpp"
#include "session/measured_slide.hpp"
#include "session/measured_trails.hpp"
#include "session/messages.hpp"
#include "session/picking.hpp"
#include "session/playback.hpp"
#include "session/project_study.hpp"
#include "session/solid_surfaces.hpp"
#include "session/splinter_list.hpp"

namespace talus {

/// All that the window holds, joined: project, frames, run, display, and what is said of them. Widgets take those that
/// they use, ask them for changes and repaint on their signals; they do not know each other.
struct Session {
  explicit Session(SolverParts parts = solverParts());

  /// Another project may take this one's place; reports a problem, about `what`, while a run goes on.
  bool isFree(const QString& what);
  /// A project file or a results folder. Reports a problem, and changes nothing, when it cannot be opened. Results are
  /// read first and shown when all is well: until then `isOpening`.
  bool open(const std::filesystem::path& path);
  bool isOpening() const { return opening_; }
  /// A project that is not in a file as it is, called `what` in the log. Reports a problem like `open`.
  bool begin(const Draft& draft, const QString& what);
  /// Empty when the rock can be cut and meshed; otherwise why not.
  QString whyNotMesh() const;
  /// Starts a run and shows its page, unless the project cannot be solved. It has a file.
  void solve();

  // In this order: the legend's range is known before the widgets are told of a frame.
  Messages messages;
  CurrentProject project;
  SolidSurfaces surfaces;
  Playback playback;
  CurrentRun run;
  MeasuredSlide slide;
  BlockHistories histories;
  ComparedResults compared;
  ProjectStudy study;
  Display display;
  MeasuredTrails trails;
  SlippedJoints slips;
  Picking picking;
  FieldLine line;
  BlockSurvey survey;
  BlockColouring colouring;
  DrawnJoints joints;
  SplinterList splinters;

 private:
  bool openProject(const std::filesystem::path& file);
  bool openResults(const std::filesystem::path& folder);
  void showResults(const std::filesystem::path& folder, const Project& found);
  void beginProject(const std::filesystem::path& path, const QString& sentence);

  ResultsLoader incoming_;  ///< looks at results before they take the place of what is open
  bool opening_ = false;
};

}  // namespace talus
