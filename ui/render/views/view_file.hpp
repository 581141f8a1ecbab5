#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/paint/painter.hpp"
#include "render/scene/scene.hpp"

namespace talus {

/// Other results that a view shows beside those that it is of.
struct ViewBeside {
  std::filesystem::path results;  ///< their folder
  bool over = false;              ///< the edges of their blocks are drawn over the view, too
};

/// What a view of results shows, and how: all that a picture depends on beside the results.
struct SavedView {
  int width = 0, height = 0;   ///< pixels, of all that is shown side by side
  std::optional<double> time;  ///< s, of the frame; the last one
  SceneSettings settings;      ///< without what is marked for a while, `fine` and `smooth_outlines`
  CameraPose camera;
  std::vector<std::string> hidden, selected;  ///< blocks, by name
  std::vector<PixelRect> covered;             ///< as Scene::set_covered, from the lower left corner of the first
  std::vector<ViewBeside> beside;             ///< up to three
};

/// The text of a view file, with folders as they are: JSON that fits resources/schema/view.schema.json.
std::string view_text(const SavedView& view);

/// The view that a text describes. Throws InputError with its place in the text for what is no such JSON, does not fit
/// the schema, or names a field there is not.
SavedView view_of_text(const std::string& text);

/// Reads a view file, folders from its own on; the place of its InputError begins with the file.
SavedView read_view(const std::filesystem::path& file);

/// Writes a view file, with folders as they are seen from its own. Throws InputError where that cannot be done.
void save_view(const SavedView& view, const std::filesystem::path& file);

/// The numbers of blocks with these names, ascending. Throws InputError for a name that no block has.
std::vector<int> blocks_named(const BlockSystem& system, const std::vector<std::string>& names);

/// Lets a scene of these blocks show the view, but for the frame and what the run tells of. Throws InputError where the
/// view is of other blocks.
void show_view(const SavedView& view, const BlockSystem& system, Scene& scene);

}  // namespace talus
