#pragma once

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include "render/paint/colour.hpp"

class vtkRenderer;

namespace talus {

/// The background's gradient, drawn where nothing else is. VTK's own gradient is lost under ambient occlusion.
class Backdrop {
 public:
  Backdrop();
  void add_to(vtkRenderer& renderer);
  void style(Rgb top, Rgb bottom);
  void show(bool shown);

 private:
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkActor2D> actor_;
};

}  // namespace talus
