#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include "render/paint/colour.hpp"

class vtkRenderer;

namespace talus {

/// The background's gradient under ambient occlusion, where VTK's own is lost. It is to be added first: smooth lines
/// are blended with what is there when they are drawn.
class Backdrop {
 public:
  Backdrop();
  void add_to(vtkRenderer& renderer);
  void style(Rgb top, Rgb bottom);
  void show(bool shown);

 private:
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkActor> actor_;
};

}  // namespace talus
