#include "render/charts/painted_image.hpp"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <string>

#include "base/error.hpp"
#include "render/gl/offscreen_window.hpp"

namespace talus {

namespace {

constexpr int smallest_chart = 320, largest_chart = 8192;

/// Thin curves want more than edges of blocks do; large plots are fine as they are.
int supersampling(int width, int height) {
  constexpr double most_pixels_drawn = 17e6;
  int scale = 3;
  while (scale > 1 && static_cast<double>(width) * height * scale * scale > most_pixels_drawn) --scale;
  return scale;
}

}  // namespace

Image painted_image(int width, int height, Rgb paper, const Painting& paint) {
  for (const int side : {width, height})
    if (side < smallest_chart || side > largest_chart)
      throw InputError("plot size " + std::to_string(width) + "x" + std::to_string(height), "cannot be drawn",
                       "use 320 to 8192 pixels a side");
  const int scale = supersampling(width, height);
  vtkNew<PainterItem> item;
  item->paint = [&](Painter& painter) { paint(painter, width * scale, height * scale); };
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(item);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(paper.red / 255.0, paper.green / 255.0, paper.blue / 255.0);
  renderer->AddActor(actor);
  OffscreenWindow window(width, height, scale);
  window.add(*renderer);
  Image image = window.draw();
  window.remove(*renderer);
  return image;
}

}  // namespace talus
