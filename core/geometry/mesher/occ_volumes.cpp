#include "geometry/mesher/occ_volumes.hpp"

#include <gmsh.h>

#include <algorithm>

#include "geometry/mesher/facet.hpp"
#include "geometry/mesher/surfaces/mended_surface.hpp"

namespace talus {
namespace {

bool is_flat(int face) {
  std::string type;
  gmsh::model::getType(2, face, type);
  return type == "Plane";
}

/// Meshes the surfaces of these volumes alone.
void mesh_faces(const std::vector<int>& volumes) {
  constexpr double initial_mesh_only = 3, frontal_delaunay = 6, pieces_of_a_turn = 36;
  const std::vector<int> faces = faces_of(volumes);
  const bool flat = std::all_of(faces.begin(), faces.end(), is_flat);
  const double longest = bounds_of(volumes).sizes().maxCoeff();
  gmsh::vectorpair everything, wanted, corners;
  gmsh::model::getEntities(everything);
  gmsh::model::setVisibility(everything, 0);
  for (const int tag : volumes) wanted.emplace_back(3, tag);
  gmsh::model::setVisibility(wanted, 1, true);
  gmsh::model::mesh::clear();
  gmsh::model::getBoundary(wanted, corners, false, false, true);
  const double size = flat ? 2 * longest : longest / 20;
  gmsh::model::mesh::setSize(corners, size);
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", flat ? 0 : pieces_of_a_turn);
  gmsh::option::setNumber("Mesh.Algorithm", flat ? initial_mesh_only : frontal_delaunay);
  gmsh::option::setNumber("Mesh.MeshOnlyVisible", 1);
  gmsh::model::mesh::generate(2);
  gmsh::option::setNumber("Mesh.MeshOnlyVisible", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", 0);
}

PolygonSoup triangles_of_faces(const std::vector<int>& faces) {
  constexpr int gmsh_triangle = 2;
  PolygonSoup soup;
  for (const int face : faces) {
    std::vector<std::size_t> nodes;
    std::vector<double> coordinates, parameters;
    gmsh::model::mesh::getNodesByElementType(gmsh_triangle, nodes, coordinates, parameters, face, false);
    for (std::size_t k = 0; k + 8 < coordinates.size(); k += 9) {
      const int first = static_cast<int>(soup.points.size());
      for (std::size_t i = k; i < k + 9; i += 3)
        soup.points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
      soup.polygons.push_back({first, first + 1, first + 2});
    }
  }
  return soup;
}

}  // namespace

Eigen::AlignedBox3d bounds_of(const std::vector<int>& volumes) {
  Eigen::AlignedBox3d bounds;
  for (int tag : volumes) {
    Vec3 low, high;
    gmsh::model::occ::getBoundingBox(3, tag, low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
    bounds.extend(low).extend(high);
  }
  return bounds;
}

double volume_of(const std::vector<int>& volumes) {
  double total = 0;
  for (int tag : volumes) {
    double volume = 0;
    gmsh::model::occ::getMass(3, tag, volume);
    total += volume;
  }
  return total;
}

int corner_count(const std::vector<int>& volumes) {
  gmsh::vectorpair wanted, corners;
  for (const int tag : volumes) wanted.emplace_back(3, tag);
  gmsh::model::getBoundary(wanted, corners, false, false, true);
  return static_cast<int>(corners.size());
}

TriangleSolid tessellated(const std::vector<int>& volumes) {
  gmsh::model::occ::synchronize();
  mesh_faces(volumes);
  TriangleSolid whole;
  for (const int volume : volumes) {
    const TriangleSolid part = mended(triangles_of_faces(faces_of({volume}))).surface;
    const int first = static_cast<int>(whole.vertices.size());
    whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& [a, b, c] : part.triangles) whole.triangles.push_back({first + a, first + b, first + c});
  }
  gmsh::model::mesh::clear();
  return whole;
}

}  // namespace talus
