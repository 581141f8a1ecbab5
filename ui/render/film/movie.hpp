#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "base/progress.hpp"
#include "render/paint/image.hpp"
#include "render/scene/scene.hpp"

namespace talus {

/// Writes a film picture by picture: .mp4 (H.264, plays everywhere) or .gif (loops). The file appears under its name
/// only when `finish()` has succeeded: failure, or destruction before it, removes what was written.
class MovieWriter {
 public:
  /// mp4 wants even sizes: an odd last row or column is left off. Throws InputError for any other ending, sizes under
  /// 16, fps outside 1…120, or a place that cannot be written.
  MovieWriter(std::filesystem::path path, int width, int height, int fps);
  ~MovieWriter();
  MovieWriter(const MovieWriter&) = delete;
  MovieWriter& operator=(const MovieWriter&) = delete;

  /// Throws std::invalid_argument when the picture has another size, std::runtime_error when encoding fails (disk
  /// full).
  void add_frame(const Image& image);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

struct FilmOptions {
  int width = 1280, height = 720;  ///< pixels, drawn with Sampling::fast
  int fps = 25;
};

/// Films `count` pictures of `scene`: frame(0) … frame(count − 1), one picture each, and reports after each.
/// The caller has set view, field and range; frame(0) and the last are included in the view here, so that the camera
/// stands still. Throws Cancelled when `progress` says so; no file is left then.
void render_film(Scene& scene, int count, const std::function<std::shared_ptr<const Frame>(int)>& frame,
                 const std::filesystem::path& path, const FilmOptions& options, Progress& progress);

}  // namespace talus
