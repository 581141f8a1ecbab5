#pragma once

#include <filesystem>
#include <memory>

#include "render/paint/image.hpp"
#include "render/scene/scene.hpp"

namespace talus {

enum class Sampling {
  best,  ///< four pixels drawn for each of the picture up to 4 megapixels; above, one and smoothed edges
  fast   ///< one, smoothed: a quarter of the time, for films
};

/// Draws a scene with no display, with a GL context of its own; keep it for several pictures (a film).
/// While it lives the scene's renderer belongs to it: give the window on the screen another Scene.
/// To be made, used and destroyed on one thread, on which no other GL context is current.
class OffscreenView {
 public:
  /// Pixels, 16…8192 each; throws InputError else, std::runtime_error where no off-screen OpenGL is to be had.
  OffscreenView(Scene& scene, int width, int height, Sampling sampling = Sampling::best);
  ~OffscreenView();
  OffscreenView(const OffscreenView&) = delete;
  OffscreenView& operator=(const OffscreenView&) = delete;

  Image draw();
  /// Fits now, unless a pose was set, and lets the camera stand still in every later picture.
  void hold_camera();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One picture of the scene.
Image draw_image(Scene& scene, int width, int height);

/// One picture of the scene as a PNG file; errors as OffscreenView and write_png.
void render_png(Scene& scene, const std::filesystem::path& path, int width, int height);

}  // namespace talus
