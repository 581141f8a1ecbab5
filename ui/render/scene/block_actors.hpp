#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <span>
#include <vector>

#include "render/paint/colour.hpp"
#include "render/scene/block_surface.hpp"

class vtkLookupTable;
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

  void add_to(vtkRenderer& renderer);
  /// `displacement` of all blocks' nodes; empty: none. `explosion`: how far blocks are drawn from where they are, over
  /// the way from the origin to their middle.
  void move(std::span<const Vec3> displacement, double scale, double explosion = 0);
  /// Draws only the blocks for which `shown[block]`.
  void show(const std::vector<bool>& shown);
  /// Faces are drawn with this opacity, those that look away not at all where it is below 1.
  void let_through(double opacity);
  void colour_by_block(const std::function<Rgb(int block)>& colour);
  /// `values` of all blocks' nodes, or tetrahedra, in the unit of `low` and `high`. Faces without a tetrahedron
  /// behind them get the table's colour for no value.
  void colour_by_values(std::span<const double> values, bool at_nodes, vtkLookupTable& table, double low, double high);
  /// Line widths in pixels; 0 leaves those edges out.
  void draw_edges(double block_edges, double mesh_edges, Rgb colour);

 private:
  BlockSurface surface_;
  Vec3 origin_;
  std::vector<Vec3> from_origin_;  ///< a vertex: from the origin to the middle of its block
  std::vector<Vec3> positions_;
  std::vector<int> drawn_;  ///< triangles that are shown, in the order of the cells
  vtkNew<vtkPoints> points_;
  vtkNew<vtkPolyData> faces_, sharp_edges_, mesh_lines_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> face_actor_, sharp_edge_actor_, mesh_actor_;
};

/// Orange outline, and a tint, of blocks or faces that are selected or under the pointer.
class Highlight {
 public:
  Highlight();
  void add_to(vtkRenderer& renderer);
  /// Marks the blocks for which `marked[block]` where they are now.
  void mark(std::span<const BlockActors* const> parts, const Vec3& origin, const std::vector<bool>& marked);
  /// The same of single triangles.
  using Chosen = std::function<bool(const BlockSurface& surface, const BlockSurface::Triangle& triangle)>;
  void mark(std::span<const BlockActors* const> parts, const Vec3& origin, const Chosen& marked);
  void style(Rgb colour, double line_width, double tint);
  bool any() const;

 private:
  vtkNew<vtkPolyData> faces_, lines_;
  vtkNew<vtkActor> face_actor_, line_actor_;
};

}  // namespace talus
