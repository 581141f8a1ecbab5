#include "render/scene/section_actor.hpp"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "render/gl/face_mapper.hpp"
#include "render/gl/line_mapper.hpp"

namespace talus {
namespace {

using Corner = BlockSection::Corner;

/// A tetrahedron is cut in a triangle or in a quadrangle.
class TetrahedraCutter {
 public:
  TetrahedraCutter(std::span<const Vec3> places, const SectionPlane& plane, BlockSection& section)
      : places_(places), plane_(plane), section_(section) {}

  void cut(const std::array<int, 4>& nodes, int block, int tetrahedron) {
    std::array<int, 4> kept{}, gone{};
    std::size_t n = 0, m = 0;
    for (const int node : nodes) (height(node) <= 0 ? kept[n++] : gone[m++]) = node;
    if (n == 0 || m == 0) return;
    const auto add = [&](const Corner& a, const Corner& b, const Corner& c) {
      section_.triangles.push_back({{a, b, c}, block, tetrahedron});
    };
    if (n == 1) return add(between(kept[0], gone[0]), between(kept[0], gone[1]), between(kept[0], gone[2]));
    if (m == 1) return add(between(kept[0], gone[0]), between(kept[1], gone[0]), between(kept[2], gone[0]));
    const Corner a = between(kept[0], gone[0]), b = between(kept[0], gone[1]), c = between(kept[1], gone[1]),
                 d = between(kept[1], gone[0]);
    add(a, b, c);
    add(a, c, d);
  }

  void outline(const std::array<int, 3>& nodes) {
    std::vector<Vec3> ends;
    for (std::size_t i = 0; i < 3; ++i) {
      const int one = nodes[i], other = nodes[(i + 1) % 3];
      if ((height(one) <= 0) != (height(other) <= 0)) ends.push_back(between(one, other).at);
    }
    if (ends.size() == 2) section_.outlines.push_back({ends[0], ends[1]});
  }

 private:
  const Vec3& place(int node) const { return places_[static_cast<std::size_t>(node)]; }
  double height(int node) const { return plane_.towards.dot(place(node) - plane_.point); }
  Corner between(int one, int other) const {
    const double share = height(one) / (height(one) - height(other));
    return {place(one) + share * (place(other) - place(one)), one, other, share};
  }

  std::span<const Vec3> places_;
  const SectionPlane& plane_;
  BlockSection& section_;
};

/// Of a solid that is seen before it is cut.
void cut_surface(const RockSurface& rock, int block, const SectionPlane& plane, BlockSection& section) {
  for (const FlatTriangle& triangle : PlaneSection(rock, plane.point, plane.towards).triangles()) {
    const auto corner = [&](std::size_t i) { return Corner{triangle[i], -1, -1, 0}; };
    section.triangles.push_back({{corner(0), corner(1), corner(2)}, block, -1});
  }
}

}  // namespace

BlockSection section_of(const BlockSystem& system, std::span<const Vec3> places, const std::vector<bool>& shown,
                        const SectionPlane& plane) {
  BlockSection section;
  TetrahedraCutter cutter(places, plane, section);
  int first_node = 0, first_tetrahedron = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    const auto numbered = [&](auto nodes) {
      for (int& node : nodes) node += first_node;
      return nodes;
    };
    if (shown[b]) {
      for (std::size_t t = 0; t < block.mesh.tetrahedra.size(); ++t)
        cutter.cut(numbered(block.mesh.tetrahedra[t]), static_cast<int>(b), first_tetrahedron + static_cast<int>(t));
      std::vector<std::array<int, 3>> surface;
      for (const SurfaceTriangle& triangle : block.surface) {
        surface.push_back(triangle.nodes);
        cutter.outline(numbered(triangle.nodes));
      }
      if (block.mesh.tetrahedra.empty())
        cut_surface({places.subspan(static_cast<std::size_t>(first_node), block.mesh.nodes.size()), surface},
                    static_cast<int>(b), plane, section);
    }
    first_node += static_cast<int>(block.mesh.nodes.size());
    first_tetrahedron += static_cast<int>(block.mesh.tetrahedra.size());
  }
  return section;
}

SectionActor::SectionActor() {
  vtkNew<FaceMapper> faces;
  faces->SetInputData(faces_);
  face_actor_->SetMapper(faces);
  face_actor_->GetProperty()->SetLighting(false);
  vtkNew<LineMapper> lines;
  lines->SetInputData(lines_);
  line_actor_->SetMapper(lines);
  line_actor_->GetProperty()->SetLighting(false);
  hide();
}

void SectionActor::add_to(vtkRenderer& renderer) {
  renderer.AddActor(face_actor_);
  renderer.AddActor(line_actor_);
}

void SectionActor::show(const BlockSection& section, const Vec3& origin,
                        const std::function<Rgb(const BlockSection::Triangle&, const Corner&)>& colour) {
  vtkNew<vtkPoints> points, ends;
  vtkNew<vtkCellArray> triangles, segments;
  vtkNew<vtkUnsignedCharArray> colours;
  for (vtkPoints* each : {points.Get(), ends.Get()}) each->SetDataTypeToDouble();
  colours->SetNumberOfComponents(3);
  const auto add = [&](vtkPoints& to, const Vec3& place) { return to.InsertNextPoint(Vec3(place - origin).data()); };
  for (const BlockSection::Triangle& triangle : section.triangles) {
    triangles->InsertNextCell(3);
    for (const Corner& corner : triangle.corners) {
      triangles->InsertCellPoint(add(*points, corner.at));
      const Rgb c = colour(triangle, corner);
      const unsigned char tuple[] = {c.red, c.green, c.blue};
      colours->InsertNextTypedTuple(tuple);
    }
  }
  for (const Edge& edge : section.outlines) {
    segments->InsertNextCell(2);
    for (const Vec3& end : edge) segments->InsertCellPoint(add(*ends, end));
  }
  faces_->SetPoints(points);
  faces_->SetPolys(triangles);
  faces_->GetPointData()->SetScalars(colours);
  lines_->SetPoints(ends);
  lines_->SetLines(segments);
  face_actor_->VisibilityOn();
  line_actor_->VisibilityOn();
}

void SectionActor::hide() {
  face_actor_->VisibilityOff();
  line_actor_->VisibilityOff();
}

void SectionActor::style(double line_width, Rgb colour, const Vec3& pixel) {
  LineMapper::style(*line_actor_, line_width);
  line_actor_->GetProperty()->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  line_actor_->SetPosition(Vec3(0.7 * pixel).data());
}

}  // namespace talus
