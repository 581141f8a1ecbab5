#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <vector>

#include "base/vector.hpp"
#include "render/gl/line_mapper.hpp"
#include "render/paint/colour.hpp"

class vtkRenderer;

namespace talus {

/// A line through points, m from the scene's origin.
struct Way {
  std::vector<Vec3> points;
  Rgb colour;
};

/// Ways in front of everything, each of one colour and all of one width.
class WayActor {
 public:
  WayActor();
  void add_to(vtkRenderer& renderer);
  void show(const std::vector<Way>& ways);
  /// `width`: pixels.
  void style(double width);

 private:
  vtkNew<vtkPolyData> lines_;
  vtkNew<LineMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace talus
