#include "render/film/movie.hpp"

#include <stdexcept>
#include <string>

#include "base/error.hpp"
#include "render/film/movie_encoder.hpp"
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

void render_film(Scene& scene, int count, const std::function<std::shared_ptr<const Frame>(int)>& frame,
                 const std::filesystem::path& path, const FilmOptions& options, Progress& progress) {
  if (count < 1) throw InputError(path.string(), "there are no frames to film", "solve first");
  scene.include_in_view(*frame(0));
  scene.include_in_view(*frame(count - 1));
  MovieWriter writer(path, options.width, options.height, options.fps);
  OffscreenView view(scene, options.width, options.height, Sampling::fast);
  scene.set_frame(frame(0));
  view.hold_camera();
  for (int i = 0; i < count; ++i) {
    if (progress.cancelled()) throw Cancelled{};
    scene.set_frame(frame(i));
    writer.add_frame(view.draw());
    progress.report((i + 1.0) / count, "picture " + std::to_string(i + 1) + " of " + std::to_string(count));
  }
  writer.finish();
}

}  // namespace talus
