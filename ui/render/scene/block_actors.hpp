#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "render/gl/face_mapper.hpp"
#include "render/paint/colour.hpp"
#include "render/scene/block_surface.hpp"

class vtkLookupTable;
class vtkPlane;
class vtkRenderer;

namespace talus {

/// Faces and edges of some blocks as VTK draws them. A new frame moves the points and nothing else.
class BlockActors {
 public:
  /// Positions are drawn relative to `origin`: what is near to zero keeps its digits on the graphics side.
  BlockActors(BlockSurface surface, const Vec3& origin);

  const BlockSurface& surface() const { return surface_; }
  const std::vector<Vec3>& positions() const { return positions_; }  ///< a vertex, m
  const std::vector<int>& drawn() const { return drawn_; }           ///< triangles that are shown
  bool shows(int block) const { return shown_[static_cast<std::size_t>(block)]; }
  vtkPoints& points() { return *points_; }  ///< the vertices as they are drawn

  /// The lines of all blocks are drawn after all faces.
  void add_faces_to(vtkRenderer& renderer);
  void add_lines_to(vtkRenderer& renderer);
  /// `displacement` of all blocks' nodes; empty: none. `explosion`: how far blocks are drawn from where they are, over
  /// the way from the origin to their middle.
  void move(std::span<const Vec3> displacement, double scale, double explosion = 0);
  /// Draws only the blocks for which `shown[block]`; their colours are to be given anew.
  void show(std::vector<bool> shown);
  /// Of those that are shown only these are drawn, until another call of `show`; without a function all of them.
  void keep(const std::function<bool(int triangle)>& kept);
  /// Fewer triangles that show about the same: they are drawn where the faces are seen through.
  struct Face {
    std::array<int, 3> vertices;
    int block;
  };
  void thin(std::vector<Face> faces);
  /// Faces are drawn with this opacity, those that look away not at all where it is below 1.
  void let_through(double opacity);
  /// Only what lies on the side of the plane's normal is drawn; null: all of it.
  void cut_by(vtkPlane* plane);
  void colour_by_block(const std::function<Rgb(int block)>& colour);
  /// `values` of all blocks' nodes, or tetrahedra, in the unit of `low` and `high`. Faces without a tetrahedron
  /// behind them get the table's colour for no value.
  void colour_by_values(std::span<const double> values, bool at_nodes, vtkLookupTable& table, double low, double high);
  /// Line widths in pixels; 0 leaves those edges out. Lines that lie closer than a few pixels are drawn paler, and
  /// those of a mesh not at all where they are no longer than that, or they would cover what they lie on. `pixel`:
  /// towards the viewer, as long as a pixel [m].
  void draw_edges(double block_edges, double mesh_edges, Rgb colour, const Vec3& pixel);

 private:
  void fill_thinned();
  /// Those that are at least so long [m].
  void show_mesh_lines(double least);
  void fill_edges(vtkPolyData& lines, bool sharp, double least);
  /// m, the area of all faces over the length of the lines on them that are so long; infinite where there are none.
  double spacing(bool sharp, double least) const;
  double length(const BlockSurface::Edge& edge) const;

  BlockSurface surface_;
  Vec3 origin_;
  std::vector<Vec3> from_origin_;  ///< a block: from the origin to the middle of its vertices
  std::vector<Vec3> positions_;
  std::vector<bool> shown_;  ///< a block
  std::vector<int> drawn_;   ///< triangles that are shown
  std::vector<int> cells_;   ///< those of them that are drawn, in the order of the cells
  bool all_kept_ = true;
  std::optional<double> mesh_lines_from_;  ///< m, the least length of those that are there
  double area_ = 0;                        ///< m², of all faces
  double spacing_of_edges_, spacing_of_mesh_;
  double shortest_ = 0;  ///< m, of all edges
  vtkNew<vtkPoints> points_;
  std::vector<Face> thinned_;
  vtkNew<vtkPolyData> faces_, thinned_faces_, sharp_edges_, mesh_lines_;
  vtkNew<FaceMapper> mapper_;
  vtkNew<vtkActor> face_actor_, sharp_edge_actor_, mesh_actor_;
};

/// Outline and tint of blocks or faces that are selected or under the pointer. It is drawn with the points of the
/// blocks, and goes with them.
class Highlight {
 public:
  using Parts = std::array<BlockActors*, 2>;
  explicit Highlight(const Parts& parts);
  void add_to(vtkRenderer& renderer);

  /// Marks these blocks, as far as they are shown.
  void mark(std::span<const int> blocks);
  /// Marks the triangles of a block that are chosen.
  using Chosen = std::function<bool(const BlockSurface& surface, const BlockSurface::Triangle& triangle)>;
  void mark(int block, const Chosen& chosen);
  void cut_by(vtkPlane* plane);
  /// `pixel`: as for draw_edges.
  void style(Rgb colour, double line_width, double tint, const Vec3& pixel);

 private:
  void mark(std::span<const int> blocks, const Chosen& chosen);

  /// Of one part.
  struct Layer {
    vtkNew<vtkPolyData> faces, lines;
    vtkNew<vtkActor> face_actor, line_actor;
  };
  Parts parts_;
  std::array<Layer, 2> layers_;
};

}  // namespace talus
