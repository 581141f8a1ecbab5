#include "mesh/structured_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace talus {

namespace {

double signed_volume(const TetMesh& mesh, const std::array<int, 4>& t) {
  const Vec3& o = mesh.nodes[t[0]];
  return (mesh.nodes[t[1]] - o).cross(mesh.nodes[t[2]] - o).dot(mesh.nodes[t[3]] - o) / 6;
}

Vec3 trilinear(const std::array<Vec3, 8>& corners, const Vec3& share) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 8; ++i)
    sum += (i & 1 ? share.x() : 1 - share.x()) * (i & 2 ? share.y() : 1 - share.y()) *
           (i & 4 ? share.z() : 1 - share.z()) * corners[i];
  return sum;
}

}  // namespace

TetMesh hexahedron_mesh(const std::array<Vec3, 8>& corners, int nx, int ny, int nz, bool mirrored) {
  TetMesh mesh;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        mesh.nodes.push_back(trilinear(
            corners, {static_cast<double>(i) / nx, static_cast<double>(j) / ny, static_cast<double>(k) / nz}));
  const std::array<int, 3> stride{1, nx + 1, (nx + 1) * (ny + 1)};
  constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        for (const auto& order : orders) {
          // A path along three edges from a corner of the cell to the one opposite; mirrored cells start at x + 1.
          std::array<int, 4> t{i * stride[0] + j * stride[1] + k * stride[2] + (mirrored ? stride[0] : 0)};
          for (int s = 0; s < 3; ++s) t[s + 1] = t[s] + (mirrored && order[s] == 0 ? -stride[0] : stride[order[s]]);
          if (signed_volume(mesh, t) < 0) std::swap(t[1], t[2]);
          if (!(signed_volume(mesh, t) > 0)) throw std::invalid_argument("hexahedron_mesh: a cell has no volume");
          mesh.tetrahedra.push_back(t);
        }
  return mesh;
}

TetMesh box_mesh(const Vec3& min, const Vec3& max, int nx, int ny, int nz, bool mirrored) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[i] = {i & 1 ? max.x() : min.x(), i & 2 ? max.y() : min.y(), i & 4 ? max.z() : min.z()};
  return hexahedron_mesh(corners, nx, ny, nz, mirrored);
}

TetMesh refined(const TetMesh& mesh) {
  TetMesh fine{mesh.nodes, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(fine.nodes.size()));
    if (is_new) fine.nodes.push_back(0.5 * (mesh.nodes[a] + mesh.nodes[b]));
    return place->second;
  };
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    const int ab = middle(a, b), ac = middle(a, c), ad = middle(a, d), bc = middle(b, c), bd = middle(b, d),
              cd = middle(c, d);
    const std::array<int, 4> parts[8] = {{a, ab, ac, ad},  {ab, b, bc, bd},  {ac, bc, c, cd},  {ad, bd, cd, d},
                                         {ab, ac, ad, cd}, {ab, ad, bd, cd}, {ab, bd, bc, cd}, {ab, bc, ac, cd}};
    for (std::array<int, 4> part : parts) {
      if (signed_volume(fine, part) < 0) std::swap(part[1], part[2]);
      fine.tetrahedra.push_back(part);
    }
  }
  return fine;
}

std::vector<SurfaceTriangle> boundary(const TetMesh& mesh) {
  constexpr int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};  // outward
  using Face = std::array<int, 3>;
  std::vector<std::pair<Face, Face>> all;  // by its nodes in order
  all.reserve(4 * mesh.tetrahedra.size());
  for (const auto& t : mesh.tetrahedra)
    for (const auto& f : faces) {
      const Face face{t[f[0]], t[f[1]], t[f[2]]};
      Face sorted = face;
      std::sort(sorted.begin(), sorted.end());
      all.emplace_back(sorted, face);
    }
  std::ranges::stable_sort(all, {}, &std::pair<Face, Face>::first);
  std::vector<SurfaceTriangle> triangles;
  for (auto same = all.begin(); same != all.end();) {
    const auto next = std::find_if(same, all.end(), [&](const auto& other) { return other.first != same->first; });
    if ((next - same) % 2 == 1) triangles.push_back({std::prev(next)->second, -1});  // what two share lies inside
    same = next;
  }
  return triangles;
}

double volume(const TetMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.tetrahedra) sum += signed_volume(mesh, t);
  return sum;
}

}  // namespace talus
