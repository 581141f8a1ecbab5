#include "render/film/movie.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/error.hpp"
#include "render/film/film_pictures.hpp"
#include "render/film/movie_encoder.hpp"
#include "render/paint/numbers.hpp"
#include "render/scene/offscreen.hpp"

namespace talus {
namespace {

constexpr int smallest_film = 16, highest_rate = 120;

std::filesystem::path partial(const std::filesystem::path& path) {
  std::filesystem::path name = path;
  return name += ".part";
}

void check(const std::filesystem::path& path, int width, int height, int fps) {
  const std::string ending = path.extension().string();
  if (ending != ".mp4" && ending != ".gif")
    throw InputError(path.string(), "unknown kind of film", "end its name with .mp4 or .gif");
  if (width < smallest_film || height < smallest_film)
    throw InputError(path.string(), "the film is too small", "use at least 16 pixels a side");
  if (fps < 1 || fps > highest_rate)
    throw InputError(path.string(), "a film cannot have " + std::to_string(fps) + " pictures a second", "use 1 to 120");
}

}  // namespace

struct MovieWriter::State {
  std::filesystem::path path;
  int width, height;
  std::unique_ptr<MovieEncoder> encoder;
};

MovieWriter::MovieWriter(std::filesystem::path path, int width, int height, int fps) {
  check(path, width, height, fps);
  state_ = std::make_unique<State>(State{std::move(path), width, height, nullptr});
  const std::filesystem::path file = partial(state_->path);
  try {
    state_->encoder = state_->path.extension() == ".gif" ? make_gif_encoder(file, width, height, fps)
                                                         : make_mp4_encoder(file, width & ~1, height & ~1, fps);
  } catch (const std::runtime_error& error) {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    throw InputError(state_->path.string(), error.what(), "choose a folder that exists, is writable and has space");
  }
}

MovieWriter::~MovieWriter() {
  if (!state_->encoder) return;
  state_->encoder.reset();
  std::error_code ignored;
  std::filesystem::remove(partial(state_->path), ignored);
}

void MovieWriter::add_frame(const Image& image) {
  if (image.width != state_->width || image.height != state_->height)
    throw std::invalid_argument("a picture of another size than the film's");
  state_->encoder->add(image);
}

void MovieWriter::finish() {
  state_->encoder->finish();
  std::filesystem::rename(partial(state_->path), state_->path);
  state_->encoder.reset();
}

std::string speed_text(double speed) {
  constexpr double rounding = 1e-9;
  if (std::abs(speed - 1) < rounding) return {};
  const double parts = 1 / speed;
  if (speed < 1 && std::abs(parts - std::round(parts)) < rounding * parts)
    return "1/" + format_decimals(parts, 0) + " of real time";
  return format_number(speed,
                       speed == std::round(speed) && speed < 1000 ? static_cast<int>(std::log10(speed)) + 1 : 3) +
         " \u00d7 real time";
}

namespace {

/// Far enough away that nothing leaves the picture while the camera turns.
CameraPose pose_for_turning(Scene& scene, const CameraMoves& moves, const BlockSystem& system) {
  constexpr int looks = 12;
  CameraPose held = scene.pose();
  const Vec3 towards = (held.position - held.focal_point).normalized();
  const CameraPath turning({.keys = {}, .turn = moves.turn, .follow = {}}, system, held);
  double distance = 0, half_height = 0;
  for (int i = 0; i <= looks; ++i) {
    scene.set_pose(turning.pose({}, static_cast<double>(i) / looks));
    scene.fit();
    const CameraPose fitted = scene.pose();
    distance = std::max(distance, (fitted.position - held.focal_point).norm());
    half_height = std::max(half_height, fitted.parallel_scale);
  }
  held.position = held.focal_point + distance * towards;
  held.parallel_scale = half_height;
  return held;
}

}  // namespace

int render_film(const Filmed& film, const std::filesystem::path& path, Progress& progress) {
  const FilmOptions& options = film.options;
  const std::vector<int> pictures = frames_of_pictures(film.times, options.speed, options.fps);
  if (pictures.empty()) throw InputError(path.string(), "there are no frames to film", "solve first");
  Scene& scene = film.scene;
  scene.include_in_view(*film.frame(0));
  scene.include_in_view(*film.frame(pictures.back()));
  MovieWriter writer(path, options.width, options.height, options.fps);
  OffscreenView view(scene, options.width, options.height, Sampling::fast);
  SceneSettings settings = scene.settings();
  settings.remark = speed_text(options.speed);
  scene.set_settings(settings);
  scene.set_frame(film.frame(0));
  view.hold_camera();
  const bool turns_about_all = options.camera.turn != 0 && options.camera.keys.empty() && !options.camera.follow;
  const CameraPath camera(options.camera, film.system,
                          turns_about_all ? pose_for_turning(scene, options.camera, film.system) : scene.pose());
  const int count = static_cast<int>(pictures.size());
  Image drawn;
  for (int i = 0, shown = -1; i < count; ++i) {
    if (progress.cancelled()) throw Cancelled{};
    const int number = pictures[static_cast<std::size_t>(i)];
    if (number != shown || !camera.stands_still()) {
      const std::shared_ptr<const Frame> frame = film.frame(number);
      if (number != shown) scene.set_frame(frame);
      if (!camera.stands_still()) scene.set_pose(camera.pose(*frame, count > 1 ? i / (count - 1.0) : 0));
      drawn = view.draw();
      shown = number;
    }
    writer.add_frame(drawn);
    progress.report((i + 1.0) / count, "picture " + std::to_string(i + 1) + " of " + std::to_string(count));
  }
  writer.finish();
  return count;
}

}  // namespace talus
