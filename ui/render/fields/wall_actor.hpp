#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <functional>
#include <span>
#include <vector>

#include "fields/joint_walls.hpp"
#include "render/gl/face_mapper.hpp"
#include "render/paint/colour.hpp"
#include "render/paint/value_range.hpp"

class vtkPlane;
class vtkRenderer;

namespace talus {

/// The walls of joints, coloured by a field, seen from both sides: where two lie on each other they tell the same.
class WallActor {
 public:
  /// Drawn relative to `origin`, as the blocks are.
  explicit WallActor(const Vec3& origin);
  void add_to(vtkRenderer& renderer);

  /// Draws those triangles of blocks that are shown which have a value at each corner. `places` [m] and `values` of all
  /// points. Of classes, a triangle has the one that most of its corners are in.
  struct Colouring {
    std::function<Rgb(double value)> colour;
    std::optional<ValueRange> only{};  ///< in which the mean of a triangle lies that is drawn; not of classes
    bool by_class = false;
  };
  void show(const JointWalls& walls, std::span<const Vec3> places, std::span<const double> values,
            const std::vector<bool>& shown, const Colouring& colouring);
  void hide();
  void cut_by(vtkPlane* plane);
  /// `pixel`: towards the viewer, as long as a pixel [m].
  void style(const Vec3& pixel);

 private:
  Vec3 origin_;
  vtkNew<vtkPolyData> mesh_;
  vtkNew<FaceMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace talus
