#include "geometry/mesher/flat_bodies.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "geometry/mesher/occ_volumes.hpp"
#include "geometry/mesher/polyhedron.hpp"
#include "geometry/mesher/surfaces/planar_faces.hpp"
#include "model/polyhedron.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

/// Vertices and edges in gmsh's model, each once. Points come in the order of the vertices: gmsh meshes by their
/// numbers.
class Wires {
 public:
  Wires(const std::vector<Vec3>& vertices, const std::vector<PlanarFace>& faces) : points_(vertices.size(), -1) {
    std::vector<bool> used(vertices.size(), false);
    for (const PlanarFace& face : faces)
      for (const std::vector<int>& loop : face.loops)
        for (const int vertex : loop) used[static_cast<std::size_t>(vertex)] = true;
    for (std::size_t v = 0; v < vertices.size(); ++v)
      if (used[v]) points_[v] = occ::addPoint(vertices[v].x(), vertices[v].y(), vertices[v].z());
  }

  int add_face(const PlanarFace& face) {
    std::vector<int> wires;
    for (const std::vector<int>& loop : face.loops) {
      std::vector<int> lines;
      for (std::size_t k = 0; k < loop.size(); ++k) lines.push_back(line(loop[k], loop[(k + 1) % loop.size()]));
      wires.push_back(occ::addCurveLoop(lines));
    }
    return occ::addPlaneSurface(wires);
  }

 private:
  int point(int vertex) const { return points_[static_cast<std::size_t>(vertex)]; }
  int line(int from, int to) {
    const auto [known, fresh] = lines_.try_emplace(std::minmax(from, to), 0);
    if (fresh) known->second = occ::addLine(point(from), point(to));
    return known->second;
  }

  std::vector<int> points_;
  std::map<std::pair<int, int>, int> lines_;
};

/// One loop for each face: holes are reached by a bridge that is walked twice.
PolyhedronShape bridged(const std::vector<Vec3>& vertices, const std::vector<PlanarFace>& faces) {
  PolyhedronShape shape{vertices, {}};
  for (const PlanarFace& face : faces) {
    std::vector<int> polygon = face.loops.front();
    for (std::size_t hole = 1; hole < face.loops.size(); ++hole) {
      polygon.push_back(face.loops.front().front());
      polygon.insert(polygon.end(), face.loops[hole].begin(), face.loops[hole].end());
      polygon.push_back(face.loops[hole].front());
    }
    shape.faces.push_back(std::move(polygon));
  }
  return shape;
}

/// Faces that hang together enclose a body or a cavity.
struct Shell {
  std::vector<std::size_t> faces;
  double volume = 0;  ///< m³, negative for a cavity
  Eigen::AlignedBox3d bounds;
};

std::vector<Shell> shells_of(const PolyhedronShape& shape) {
  std::map<std::pair<int, int>, std::size_t> owner;
  const auto edges = [&](std::size_t f, const auto& act) {
    const std::vector<int>& face = shape.faces[f];
    for (std::size_t k = 0; k < face.size(); ++k) act(face[k], face[(k + 1) % face.size()]);
  };
  for (std::size_t f = 0; f < shape.faces.size(); ++f) edges(f, [&](int a, int b) { owner[{a, b}] = f; });
  std::vector<bool> reached(shape.faces.size(), false);
  std::vector<Shell> shells;
  for (std::size_t seed = 0; seed < shape.faces.size(); ++seed) {
    if (reached[seed]) continue;
    Shell shell;
    shell.faces = {seed};
    reached[seed] = true;
    PolyhedronShape alone{shape.vertices, {}};
    for (std::size_t i = 0; i < shell.faces.size(); ++i) {
      alone.faces.push_back(shape.faces[shell.faces[i]]);
      edges(shell.faces[i], [&](int a, int b) {
        shell.bounds.extend(shape.vertices[static_cast<std::size_t>(a)]);
        const std::size_t beside = owner.at({b, a});
        if (reached[beside]) return;
        reached[beside] = true;
        shell.faces.push_back(beside);
      });
    }
    shell.volume = signed_volume(alone);
    shells.push_back(std::move(shell));
  }
  return shells;
}

/// Cavities are cut out of the smallest body around them.
std::vector<int> add_volumes(const std::vector<Shell>& shells, const std::vector<int>& faces) {
  std::vector<int> volumes;
  for (const Shell& shell : shells) {
    std::vector<int> tags;
    for (const std::size_t f : shell.faces) tags.push_back(faces[f]);
    volumes.push_back(occ::addVolume({occ::addSurfaceLoop(tags)}));
  }
  std::map<std::size_t, gmsh::vectorpair> cavities;  // by body
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (shells[i].volume > 0) continue;
    std::optional<std::size_t> around;
    for (std::size_t body = 0; body < shells.size(); ++body)
      if (shells[body].volume > 0 && shells[body].bounds.contains(shells[i].bounds) &&
          (!around || shells[body].volume < shells[*around].volume))
        around = body;
    if (around) cavities[*around].emplace_back(3, volumes[i]);
  }
  std::vector<int> bodies;
  for (std::size_t body = 0; body < shells.size(); ++body) {
    if (shells[body].volume <= 0) continue;
    gmsh::vectorpair left{{3, volumes[body]}};
    std::vector<gmsh::vectorpair> ancestry;
    if (cavities.contains(body)) occ::cut({{3, volumes[body]}}, cavities[body], left, ancestry);
    for (const auto& [dimension, tag] : left) bodies.push_back(tag);
  }
  return bodies;
}

std::vector<PlanarFace> with_single_loops(const PolyhedronShape& shape) {
  std::vector<PlanarFace> faces;
  for (const std::vector<int>& face : shape.faces) faces.push_back({{face}});
  return faces;
}

std::vector<int> add_faces(const std::vector<Vec3>& vertices, const std::vector<PlanarFace>& faces) {
  Wires wires(vertices, faces);
  std::vector<int> tags;
  for (const PlanarFace& face : faces) tags.push_back(wires.add_face(face));
  return tags;
}

}  // namespace

int add_polyhedron(const PolyhedronShape& shape) {
  return occ::addVolume({occ::addSurfaceLoop(add_faces(shape.vertices, with_single_loops(shape)))});
}

std::vector<int> add_flat_bodies(const TriangleSolid& solid, std::size_t most_faces) {
  const std::vector<PlanarFace> faces = planar_faces(solid);
  if (faces.size() > most_faces) return {};
  try {
    const PolyhedronShape shape = with_flat_faces(bridged(solid.vertices, faces), "solid");
    const std::vector<Shell> shells = shells_of(shape);
    const std::vector<int> volumes = add_volumes(shells, add_faces(shape.vertices, faces));
    const double wanted = std::accumulate(shells.begin(), shells.end(), 0.0,
                                          [](double sum, const Shell& shell) { return sum + shell.volume; });
    constexpr double same = 1e-9;
    if (std::abs(volume_of(volumes) - wanted) <= same * wanted) return volumes;
  } catch (const std::string&) {  // gmsh's
  } catch (const InputError&) {   // faces that cannot all be flat
  }
  return {};
}

}  // namespace talus
