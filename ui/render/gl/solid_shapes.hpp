#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <array>
#include <vector>

#include "base/vector.hpp"
#include "render/paint/colour.hpp"

class vtkRenderer;

namespace talus {

/// Triangles that grow one by one, with a colour and a normal at each corner, and what draws them in front of the rock.
class SolidMesh {
 public:
  SolidMesh();
  vtkActor& actor() { return *actor_; }
  void clear();
  /// A round bar about the line from `start` to `end`, m from the scene's origin, of these radii, m; a cone where one
  /// is 0.
  void add_bar(const Vec3& start, const Vec3& end, double start_radius, double end_radius, Rgb colour);
  void add_ball(const Vec3& centre, double radius, Rgb colour);
  /// Shows what was added since `clear`.
  void finish();

 private:
  /// A triangle of the round end of a bar, counter-clockwise seen from outside.
  void add_cap(const Vec3& centre, const Vec3& from, const Vec3& to, const Vec3& normal, Rgb colour);
  int add_point(const Vec3& place, const Vec3& normal, Rgb colour);

  std::vector<Vec3> places_, normals_;
  std::vector<Rgb> colours_;
  std::vector<std::array<int, 3>> triangles_;
  vtkNew<vtkPolyData> mesh_;
  vtkNew<vtkActor> actor_;
};

/// Round bars, cones and balls, shaded, in front of everything: signs in the picture, which the rock does not hide.
/// Each has a rim, so that it is seen on rock of its own colour too.
class SolidShapes {
 public:
  SolidShapes();
  void add_to(vtkRenderer& renderer);

  /// What is added from now on has rims of this width, m, and colour.
  void clear(double rim, Rgb rim_colour);
  /// As a SolidMesh has them.
  void add_bar(const Vec3& start, const Vec3& end, double start_radius, double end_radius, Rgb colour);
  void add_ball(const Vec3& centre, double radius, Rgb colour);
  void finish();

 private:
  SolidMesh shapes_, rims_;  ///< a rim is the far side of a larger shape
  double rim_ = 0;
  Rgb rim_colour_;
};

}  // namespace talus
