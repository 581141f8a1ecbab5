#include "render/film/movie.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/error.hpp"
#include "render/film/film_pictures.hpp"
#include "render/film/movie_encoder.hpp"
#include "render/film/side_by_side.hpp"
#include "render/paint/numbers.hpp"
#include "render/paint/picture_words.hpp"

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
    return "1/" + format_decimals(parts, 0) + " " + picture_word("of real time");
  return format_number(speed,
                       speed == std::round(speed) && speed < 1000 ? static_cast<int>(std::log10(speed)) + 1 : 3) +
         " \u00d7 " + picture_word("real time");
}

namespace {

/// Far enough away that nothing leaves the picture while the camera turns.
CameraPose pose_for_turning(const std::vector<Filmed>& films, const CameraMoves& moves) {
  constexpr int looks = 12;
  CameraPose held = films.front().scene.pose();
  const Vec3 towards = (held.position - held.focal_point).normalized();
  const CameraPath turning({.keys = {}, .turn = moves.turn, .follow = {}}, films.front().system, held);
  double distance = 0, half_height = 0;
  for (const Filmed& film : films)
    for (int i = 0; i <= looks; ++i) {
      film.scene.set_pose(turning.pose({}, static_cast<double>(i) / looks));
      film.scene.fit();
      const CameraPose fitted = film.scene.pose();
      distance = std::max(distance, (fitted.position - held.focal_point).norm());
      half_height = std::max(half_height, fitted.parallel_scale);
    }
  held.position = held.focal_point + distance * towards;
  held.parallel_scale = half_height;
  return held;
}

FilmClock clock_of(const std::vector<Filmed>& films, const FilmOptions& options) {
  FilmClock clock{films.front().times.front(), films.front().times.back(), options.speed, options.fps};
  for (const Filmed& film : films) {
    clock.begin = std::min(clock.begin, film.times.front());
    clock.end = std::max(clock.end, film.times.back());
  }
  clock.begin = std::max(clock.begin, options.from.value_or(clock.begin));
  clock.end = std::min(clock.end, options.to.value_or(clock.end));
  if (clock.begin > clock.end)
    throw InputError("film", "no frames lie between its beginning and its end", "choose moments of the run, in order");
  return clock;
}

}  // namespace

int render_film(const std::vector<Filmed>& films, const FilmOptions& options, const std::filesystem::path& path,
                Progress& progress) {
  for (const Filmed& film : films)
    if (film.times.empty()) throw InputError(path.string(), "there are no frames to film", "solve first");
  const int count = clock_of(films, options).pictures();
  std::vector<std::vector<int>> frames;  // of each, which one a picture shows
  std::vector<Scene*> scenes;
  for (const Filmed& film : films) {
    frames.push_back(frames_of_pictures(film.times, clock_of(films, options)));
    if (scenes.empty() || !options.over) scenes.push_back(&film.scene);
    film.scene.include_in_view(*film.frame(0));
    film.scene.include_in_view(*film.frame(static_cast<int>(film.times.size()) - 1));
  }
  MovieWriter writer(path, options.width, options.height, options.fps);
  SideBySideView view(scenes, options.width, options.height, Sampling::fast);
  for (const Filmed& film : films) {
    SceneSettings settings = film.scene.settings();
    settings.remark = speed_text(options.speed);
    film.scene.set_settings(settings);
    film.scene.set_frame(film.frame(0));
  }
  view.hold_camera();
  const bool turns_about_all = options.camera.turn != 0 && options.camera.keys.empty() && !options.camera.follow;
  const CameraPath camera(options.camera, films.front().system,
                          turns_about_all ? pose_for_turning(films, options.camera) : view.pose());
  Image drawn;
  std::vector<int> shown(films.size(), -1);
  std::shared_ptr<const Frame> leading;
  for (int i = 0; i < count; ++i) {
    if (progress.cancelled()) throw Cancelled{};
    bool is_new = !camera.stands_still();
    for (std::size_t k = 0; k < films.size(); ++k) {
      const int number = frames[k][static_cast<std::size_t>(i)];
      if (number == shown[k]) continue;
      const std::shared_ptr<const Frame> frame = films[k].frame(number);
      if (k == 0) leading = frame;
      if (k > 0 && options.over)
        films.front().scene.set_ghost({borrowed(films[k].system), frame, films[k].name});
      else
        films[k].scene.set_frame(frame);
      shown[k] = number;
      is_new = true;
    }
    if (!camera.stands_still()) view.set_pose(camera.pose(*leading, count > 1 ? i / (count - 1.0) : 0));
    if (is_new) drawn = view.draw();
    writer.add_frame(drawn);
    progress.report((i + 1.0) / count, "picture " + std::to_string(i + 1) + " of " + std::to_string(count));
  }
  writer.finish();
  return count;
}

}  // namespace talus
