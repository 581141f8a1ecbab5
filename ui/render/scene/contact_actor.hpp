#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <span>

#include "results/frame.hpp"

class vtkRenderer;

namespace talus {

/// Contact points as dots in front of everything (they lie between blocks): open grey, stick blue, slip orange.
class ContactActor {
 public:
  ContactActor();
  void add_to(vtkRenderer& renderer);
  /// `places`: one for each, m.
  void show(std::span<const ContactSample> contacts, std::span<const Vec3> places, const Vec3& origin,
            double size_in_pixels);

 private:
  vtkNew<vtkPolyData> points_;
  vtkNew<vtkActor> actor_;
};

}  // namespace talus
