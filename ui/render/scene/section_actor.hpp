#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "render/paint/colour.hpp"
#include "render/scene/block_surface.hpp"
#include "render/scene/joint_face.hpp"
#include "render/scene/scene.hpp"

class vtkRenderer;

namespace talus {

/// Where a plane lies in blocks.
struct BlockSection {
  /// A corner lies between two nodes, numbered through all blocks.
  struct Corner {
    Vec3 at;         ///< m
    int one, other;  ///< −1: of a block without tetrahedra
    double share;    ///< of the way from the one to the other
  };
  struct Triangle {
    std::array<Corner, 3> corners;
    int block;
    int tetrahedron;  ///< numbered through all blocks; −1: of a block without
  };
  std::vector<Triangle> triangles;
  std::vector<Edge> outlines;  ///< of the blocks
};

/// Of blocks for which `shown[block]`; `places` [m] of all nodes.
BlockSection section_of(const BlockSystem& system, std::span<const Vec3> places, const std::vector<bool>& shown,
                        const SectionPlane& plane);

/// The inside of blocks that a section cuts, as VTK draws it.
class SectionActor {
 public:
  SectionActor();
  void add_to(vtkRenderer& renderer);
  /// Positions are drawn relative to `origin`.
  void show(const BlockSection& section, const Vec3& origin,
            const std::function<Rgb(const BlockSection::Triangle&, const BlockSection::Corner&)>& colour);
  void hide();
  /// Of the blocks' outlines. `pixel`: towards the viewer, as long as a pixel [m].
  void style(double line_width, Rgb colour, const Vec3& pixel);

 private:
  vtkNew<vtkPolyData> faces_, lines_;
  vtkNew<vtkActor> face_actor_, line_actor_;
};

}  // namespace talus
