#pragma once

#include <CLI/App.hpp>

#include <filesystem>
#include <optional>
#include <string>

#include "render/paint/image.hpp"
#include "render/scene/scene.hpp"
#include "results/result_folder.hpp"

// Options that several commands share, each with its unit and default in its help.
namespace talus::cli {

struct PictureSize {
  int width, height;
};

void add_results(CLI::App& command, std::filesystem::path& results);
CLI::Option* add_size(CLI::App& command, PictureSize& size);
void add_theme(CLI::App& command, Theme& theme);
void add_threads(CLI::App& command, int& threads);

/// One frame of the results: the one nearest to a time, or by number, or the last.
struct FrameChoice {
  std::optional<double> time;
  std::optional<int> frame;
};
/// `otherwise`: which frames are meant where none is chosen.
void add_frame_choice(CLI::App& command, FrameChoice& choice, const std::string& otherwise = "the last");
/// Throws InputError when the results hold no such frame.
int frame_index(const ResultReader& results, const FrameChoice& choice);

/// What a picture or a film shows and from where.
struct Look {
  std::string field, view = "auto";
  std::optional<std::string> title{};  ///< none: the project's name
  Theme theme = Theme::light;
  Edges edges = Edges::blocks;
  bool contacts = false, troubles = false;
  double scale = 1, explosion = 0;
  std::optional<ValueRange> range;  ///< of the legend, SI
  std::optional<ValueRange> only;   ///< values of faces that are drawn, SI
  Arrows arrows = Arrows::none;
  bool trails = false, turning_axes = false;
  std::filesystem::path view_file;  ///< saved by the window, says all of this itself; empty: none
};
void add_look(CLI::App& command, Look& look);
/// Throws InputError for a field or a view there is not.
SceneSettings scene_settings(const Look& look, const ResultReader& results);
/// Those of the project that the results keep; none where that is gone.
std::vector<ActionGlyph> monitors_of(const std::filesystem::path& folder, const ResultReader& results);
/// Tells a scene that is to show trails the ways of all blocks.
void tell_trails(const ResultReader& results, Scene& scene);
/// Marks where the run was hard, if that was asked for; of a run that was killed nothing is known.
void mark_troubles(const Look& look, const ResultReader& results, Scene& scene);
/// Points the camera of a scene that shows `results`. Throws InputError for a view there is not.
void point_camera(const Look& look, const ResultReader& results, Scene& scene);

}  // namespace talus::cli
