#pragma once

#include <memory>

#include "render/paint/image.hpp"
#include "render/views/view_file.hpp"
#include "results/result_folder.hpp"

namespace talus {

/// A scene that shows a saved view of results: with the stages' names, the project's `monitors`, and where the run was
/// hard, but without a frame. `pixels` false: for pictures of another size, with smooth outlines,
/// writing that suits their height, and nothing lying over them. Keeps a reference to the blocks of `results`. Throws
/// InputError where the view is of other blocks.
std::unique_ptr<Scene> scene_of_view(const SavedView& view, const ResultReader& results,
                                     std::vector<ActionGlyph> monitors, bool pixels);

/// The frame that the view shows: the nearest to its time, or the last. Throws InputError where there is none.
int frame_of_view(const SavedView& view, const ResultReader& results);

/// The picture that the window showed, pixel for pixel where it was drawn by the same OpenGL.
Image draw_view(Scene& scene, const SavedView& view);

}  // namespace talus
