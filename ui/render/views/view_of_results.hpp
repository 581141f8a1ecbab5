#pragma once

#include <memory>

#include "render/views/view_file.hpp"
#include "results/result_folder.hpp"

namespace talus {

/// Throws InputError where the frame does not tell of the field that is to be shown.
void need_field(const BlockSystem& system, const Frame& frame, const SceneSettings& settings);

/// A scene that shows a saved view of results: with the stages' names, the project's `monitors`, and where the run was
/// hard, but without a frame. `pixels` false: for pictures of another size, with smooth outlines,
/// writing that suits their height, and nothing lying over them. Keeps a reference to the blocks of `results`. Throws
/// InputError where the view is of other blocks.
std::unique_ptr<Scene> scene_of_view(const SavedView& view, const ResultReader& results,
                                     std::vector<ActionGlyph> monitors, bool pixels);

/// The frame that the view shows: the nearest to its time, or the last. Throws InputError where there is none.
int frame_of_view(const SavedView& view, const ResultReader& results);

/// What results are shown by that stand under a name beside a view that is shown by `view`.
SceneSettings settings_beside(const SceneSettings& view, const std::string& name);

/// Results that a view shows beside those that it is of.
struct SceneBeside {
  std::filesystem::path folder;
  std::unique_ptr<ResultReader> results;
  int number;                          ///< of the frame, the nearest to some moment
  std::shared_ptr<const Frame> frame;  ///< that the scene shows
  std::unique_ptr<Scene> scene;
};

/// All of them, at a `time` [s], made as scene_of_view makes `first`, which is of the results in `folder` and gets the
/// name that tells these from the others, and the edges of what is drawn over it. Throws InputError for results that
/// cannot be read, have no frame, or do not tell of the field.
std::vector<SceneBeside> scenes_beside(const SavedView& view, const std::filesystem::path& folder, double time,
                                       Scene& first);

}  // namespace talus
