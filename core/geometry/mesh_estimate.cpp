#include "geometry/mesh_estimate.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "base/memory_limit.hpp"
#include "geometry/block_description.hpp"
#include "geometry/corner_solids.hpp"
#include "mesh/mesh_size.hpp"
#include "mesh/size_field.hpp"
#include "model/about_text.hpp"
#include "model/number_text.hpp"

namespace talus {
namespace {

using Box = Eigen::AlignedBox3d;

/// Whether of all refinements this one says the size in the point.
bool decides(std::size_t index, const Vec3& point, double own, std::span<const MeshRefinement> refinements) {
  const double size = size_at(point, own, refinements);
  for (std::size_t i = 0; i <= index; ++i)
    if (size_at(point, own, refinements.subspan(i, 1)) == size) return i == index;
  return false;
}

/// 1/m³, mean over the box of one over the cube of the size: one for own size alone, more where refinements reach in.
double mean_density(const BlockToMesh& block, std::span<const MeshRefinement> refinements) {
  constexpr int samples = 16;  // a side
  const Box box(block.min, block.max);
  const auto density = [](double size) { return 1 / (size * size * size); };
  const double own = density(block.size);
  double more = 0;
  for (std::size_t i = 0; i < refinements.size(); ++i) {
    const Vec3 reach = Vec3::Constant(2 * refinements[i].radius);
    const Box near = box_of(refinements[i]);
    const Box common = box.intersection(Box(near.min() - reach, near.max() + reach));
    if (common.isEmpty()) continue;
    for (int k = 0; k < samples * samples * samples; ++k) {
      const Eigen::Array3d cell(k % samples, k / samples % samples, k / (samples * samples));
      const Vec3 point = common.min().array() + (cell + 0.5) / samples * common.sizes().array();
      if (!decides(i, point, block.size, refinements)) continue;
      const double size = size_at(point, block.size, refinements);
      more += (density(size) - own) * common.volume() / (samples * samples * samples);
    }
  }
  return own + more / box.volume();
}

struct Counts {
  double tetrahedra = 0, nodes = 0;
};

/// Fitted to gmsh's Delaunay meshes (4.8.4, Optimize = 1) of blocks from a quarter of an edge to fifty across, cut from
/// a cube, and from rough terrain as cells.
struct Fit {
  double triangles_in_a_square, triangles_along_edges;  ///< of one edge's area; for its root, as if a block were a cube
  double tetrahedra_in_a_cube, nodes_in_a_cube;         ///< of one edge
  double on_smaller_triangles;                          ///< tetrahedra that stand on one, where they are much smaller
};
constexpr Fit of_solids{2.3, 5.9, 4.4, 0.4, 1.08}, of_cells{2.0, 4.5, 3.3, 0.15, 1.05};

double triangles_between(double corners) { return 2 * (std::max(4.0, corners) - 2); }  // Euler

/// Triangles of a block's surface: as many as its size asks for, at least those that its corners make. A surface of
/// facets that are as small as the size is in between.
double triangles_of(double squares, double corners, const Fit& fit) {
  constexpr double sharpness = 1.5;
  const double by_size = fit.triangles_in_a_square * squares + fit.triangles_along_edges * std::sqrt(squares);
  return std::pow(std::pow(by_size, sharpness) + std::pow(triangles_between(corners), sharpness), 1 / sharpness);
}

Counts counts_of(const BlockToMesh& block, std::span<const MeshRefinement> refinements) {
  if (block.stands_on_corners()) return {triangles_between(block.corners), block.corners + 1};
  constexpr double on_triangles_of_the_size = 0.46, usual_in_a_square = 2.63, least = 12;
  const Fit& fit = block.of_cells ? of_cells : of_solids;
  const std::span<const MeshRefinement> reaching = block.refined ? refinements : std::span<const MeshRefinement>();
  const double density = mean_density(block, reaching);
  const double cubes = block.volume * density, squares = block.area * std::pow(density, 2.0 / 3);
  const double triangles = triangles_of(squares, block.corners, fit);
  const double of_the_size = std::min(1.0, usual_in_a_square * squares / triangles);
  const double on_a_triangle = std::lerp(fit.on_smaller_triangles, on_triangles_of_the_size, of_the_size);
  const double on_surface = triangles / 2 + 2;  // Euler
  return {std::max(fit.tetrahedra_in_a_cube * cubes + on_a_triangle * triangles, least),
          on_surface + fit.nodes_in_a_cube * cubes};
}

double seconds_of(const BlockToMesh& block, const Counts& counts) {
  constexpr double a_tetrahedron = 45e-6, a_block = 5e-3, a_block_of_corners = 2e-4;
  return block.stands_on_corners() ? a_block_of_corners : a_block + a_tetrahedron * counts.tetrahedra;
}

/// The mesher holds all that was cut, gmsh one block at a time, the program keeps them all.
class Held {
 public:
  void add(const BlockToMesh& block, const Counts& counts) {
    kept_ += counts.tetrahedra;
    if (block.stands_on_corners()) {
      cell_corners_ += block.corners;
    } else {
      corners_ += block.corners;
      largest_ = std::max(largest_, counts.tetrahedra);
    }
  }
  double bytes() const {
    constexpr double of_gmsh = 45e6, of_opencascade = 30e6, a_corner = 7e3, a_corner_of_cells = 1e3, at_work = 550,
                     kept = 60;
    return of_gmsh + (corners_ > 0 ? of_opencascade : 0) + a_corner * corners_ + a_corner_of_cells * cell_corners_ +
           at_work * largest_ + kept * kept_;
  }

 private:
  double corners_ = 0, cell_corners_ = 0;
  double largest_ = 0, kept_ = 0;  ///< tetrahedra
};

double unknowns_of(BodyKind body, double nodes) {
  switch (body) {
    case BodyKind::fixed:
      return 0;
    case BodyKind::rigid:
      return 6;
    case BodyKind::affine:
      return 12;
    case BodyKind::tetrahedra:
    case BodyKind::automatic:
      break;
  }
  return 3 * nodes;
}

using ExtentOfSolids = std::map<int, Box>;

ExtentOfSolids extents(const BlockSystem& system) {
  ExtentOfSolids boxes;
  for (const Block& block : system.blocks)
    for (const Vec3& node : block.mesh.nodes) boxes[block.solid].extend(node);
  return boxes;
}

Vec3 normal_of(const Block& block, const SurfaceTriangle& triangle) {
  const auto node = [&](std::size_t k) -> const Vec3& {
    return block.mesh.nodes[static_cast<std::size_t>(triangle.nodes[k])];
  };
  return (node(1) - node(0)).cross(node(2) - node(0)).normalized();
}

/// However finely the block is meshed.
double corners_of(const Block& block) {
  constexpr double in_one_plane = 0.9994;  // cosine of 2°
  std::vector<std::vector<Vec3>> planes(block.mesh.nodes.size());
  for (const SurfaceTriangle& triangle : block.surface) {
    const Vec3 normal = normal_of(block, triangle);
    for (const int node : triangle.nodes) {
      auto& known = planes[static_cast<std::size_t>(node)];
      const auto is_known = [&](const Vec3& one) { return one.dot(normal) > in_one_plane; };
      if (known.size() < 3 && std::ranges::none_of(known, is_known)) known.push_back(normal);
    }
  }
  return static_cast<double>(std::ranges::count_if(planes, [](const auto& known) { return known.size() >= 3; }));
}

double surface_area(const Block& block) {
  double area = 0;
  for (const SurfaceTriangle& t : block.surface) {
    const auto node = [&](std::size_t k) -> const Vec3& {
      return block.mesh.nodes[static_cast<std::size_t>(t.nodes[k])];
    };
    area += (node(1) - node(0)).cross(node(2) - node(0)).norm() / 2;
  }
  return area;
}

/// What the project wants a block to be now; left open, what it is.
BodyKind wanted_body(const Block& block, const Solid& solid, const BlockOverride* wanted) {
  const BodyKind body = wanted ? wanted->body.value_or(solid.body) : solid.body;
  return body == BodyKind::automatic ? block.body : body;
}

/// `of_corners`: all blocks of its solid stand on their corners.
BlockToMesh block_to_mesh(const Project& project, const Block& block, const Box& solid_box, bool of_corners) {
  const Solid& solid = project.solids[static_cast<std::size_t>(block.solid)];
  const auto named = std::ranges::find(project.blocks, block.name, &BlockOverride::name);
  const BlockOverride* wanted = named == project.blocks.end() ? nullptr : &*named;
  const BodyKind body = wanted_body(block, solid, wanted);
  const bool is_of_cells = of_corners || std::holds_alternative<TerrainShape>(solid.shape);
  const bool coarse = corners_suffice(body, solid, wanted, is_of_cells);
  const double usual = solid.mesh_size.value_or(project.mesh.size.value_or(solid_box.sizes().maxCoeff() / 10));
  Box box;
  for (const Vec3& node : block.mesh.nodes) box.extend(node);
  return {body,
          coarse ? solid_box.diagonal().norm() : (wanted && wanted->mesh_size ? *wanted->mesh_size : usual),
          !coarse,
          block.volume,
          surface_area(block),
          box.min(),
          box.max(),
          is_of_cells,
          corners_of(block)};
}

}  // namespace

MeshEstimate mesh_estimate(std::span<const BlockToMesh> blocks, std::span<const MeshRefinement> refinements) {
  MeshEstimate estimate;
  Held held;
  for (const BlockToMesh& block : blocks) {
    const Counts counts = counts_of(block, refinements);
    estimate.tetrahedra += counts.tetrahedra;
    estimate.nodes += counts.nodes;
    estimate.unknowns += unknowns_of(block.body, counts.nodes);
    estimate.seconds += seconds_of(block, counts);
    held.add(block, counts);
  }
  estimate.bytes = held.bytes();
  return estimate;
}

MeshEstimate mesh_estimate(const Project& project, const BlockSystem& cut) {
  const ExtentOfSolids solids = extents(cut);
  std::vector<BlockToMesh> blocks;
  const std::vector<bool> of_corners = corner_solids(project);
  for (const Block& block : cut.blocks)
    blocks.push_back(
        block_to_mesh(project, block, solids.at(block.solid), of_corners[static_cast<std::size_t>(block.solid)]));
  return mesh_estimate(blocks, project.mesh.refinements);
}

bool is_needle(const BlockToMesh& block) {
  return !block.stands_on_corners() && is_needle((block.max - block.min).norm(), block.area, block.size);
}

void require_a_mesh_that_fits(const Project& project, const MeshEstimate& estimate) {
  const std::string coarser = "make mesh sizes larger, blocks rigid or affine";
  if (estimate.tetrahedra > project.mesh.most_tetrahedra)
    throw InputError("/mesh/most_tetrahedra",
                     "the mesh would have about " + significant(estimate.tetrahedra, 2) + " tetrahedra, more than " +
                         number_text(project.mesh.most_tetrahedra),
                     coarser + ", or allow more");
  require_memory(estimate.bytes, "/mesh", "meshing about " + about_text(estimate.tetrahedra) + " tetrahedra", coarser);
}

}  // namespace talus
