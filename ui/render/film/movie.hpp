#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "render/film/camera_path.hpp"
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
  double speed = 1;                    ///< seconds of the model in a second of film
  std::optional<double> from{}, to{};  ///< s of the model; the first frame, the last
  CameraMoves camera{};
  bool over = false;  ///< results are drawn over the first ones, as outlines, and not beside them
};

/// What is filmed. The caller has set view, field and range.
struct Filmed {
  Scene& scene;
  const BlockSystem& system;
  std::vector<double> times;                               ///< s, of the frames
  std::function<std::shared_ptr<const Frame>(int)> frame;  ///< by number
  std::string name{};                                      ///< where it is drawn over others
};

/// Films all frames of results, of several beside each other: each shows the frame that is nearest to the moment, from
/// the same place. Reports after each picture; each says how fast the film is, where that is not real time. The first
/// frame and the last are included in the view here, so that the camera stands still where it is not to move; one that
/// follows a block goes along with that of the first results. Throws Cancelled when `progress` says so; no file is left
/// then. Returns the number of pictures; none that would be as the one before is drawn again.
int render_film(const std::vector<Filmed>& films, const FilmOptions& options, const std::filesystem::path& path,
                Progress& progress);

/// "4 × real time", "1/10 of real time"; empty for real time.
std::string speed_text(double speed);

}  // namespace talus
