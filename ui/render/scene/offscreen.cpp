#include "render/scene/offscreen.hpp"

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <string>

#include "base/error.hpp"
#include "render/gl/offscreen_window.hpp"
#include "render/scene/scene_state.hpp"

namespace talus {
namespace {

constexpr int smallest_side = 16, largest_side = 8192;
/// Up to here four pixels are drawn for each one of the picture; above, memory and time cost more than smoother edges.
constexpr double most_pixels_drawn = 17e6;

int supersampling(int width, int height, Sampling sampling) {
  return sampling == Sampling::best && 4.0 * width * height <= most_pixels_drawn ? 2 : 1;
}

}  // namespace

struct OffscreenView::State {
  State(Scene& drawn, int width, int height, Sampling sampling)
      : scene(drawn), scale(supersampling(width, height, sampling)), window(width, height, scale) {
    window.add(*scene.renderer());
    scene.state_->pixel_scale = scale;
  }
  ~State() {
    scene.state_->pixel_scale = 1;
    window.remove(*scene.renderer());
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  Scene& scene;
  int scale;
  OffscreenWindow window;
};

OffscreenView::OffscreenView(Scene& scene, int width, int height, Sampling sampling) {
  for (const int side : {width, height})
    if (side < smallest_side || side > largest_side)
      throw InputError("size " + std::to_string(width) + "x" + std::to_string(height), "cannot be drawn",
                       "use 16 to 8192 pixels a side");
  state_ = std::make_unique<State>(scene, width, height, sampling);
}

OffscreenView::~OffscreenView() = default;

Image OffscreenView::draw() {
  Scene& scene = state_->scene;
  if (scene.state_->fits_itself) scene.fit();
  return state_->window.draw();
}

void OffscreenView::hold_camera() {
  Scene& scene = state_->scene;
  if (scene.state_->fits_itself) scene.fit();
  scene.set_pose(scene.pose());
}

Image draw_image(Scene& scene, int width, int height) { return OffscreenView(scene, width, height).draw(); }

void render_png(Scene& scene, const std::filesystem::path& path, int width, int height) {
  write_png(draw_image(scene, width, height), path);
}

}  // namespace talus
