#pragma once

#include <filesystem>

#include "session/current_project.hpp"
#include "session/current_run.hpp"
#include "session/display.hpp"
#include "session/messages.hpp"
#include "session/playback.hpp"

namespace talus {

/// All that the window holds, joined: project, frames, run, display, and what is said of them. Widgets take those that
/// they use, ask them for changes and repaint on their signals; they do not know each other.
struct Session {
  explicit Session(SolverParts parts = solverParts());

  /// A project file or a results folder. Reports a problem, and changes nothing, when it cannot be opened.
  bool open(const std::filesystem::path& path);
  /// Starts a run and shows its page, unless the project cannot be solved.
  void solve();

  // In this order: the legend's range is known before the widgets are told of a frame.
  Messages messages;
  CurrentProject project;
  Playback playback;
  CurrentRun run;
  Display display;

 private:
  bool openProject(const std::filesystem::path& file);
  bool openResults(const std::filesystem::path& folder);
  void beginProject(const std::filesystem::path& path, const QString& sentence);
};

}  // namespace talus
