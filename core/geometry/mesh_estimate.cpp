#include "geometry/mesh_estimate.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "geometry/block_description.hpp"
#include "mesh/size_field.hpp"
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
    const Box common = box.intersection(Box(refinements[i].at - reach, refinements[i].at + reach));
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

/// Fitted to gmsh's Delaunay meshes (4.8.4, Optimize = 1) of cubes, plates and columns, from one edge to fifty across:
/// so many tetrahedra fill a cube of one edge, and so many lie along a square of it on the surface.
Counts counts_of(const BlockToMesh& block, std::span<const MeshRefinement> refinements) {
  constexpr double inside = 4.4, along_surface = 1.2, of_one_layer = 3.5, least = 12;
  const std::span<const MeshRefinement> reaching = block.refined ? refinements : std::span<const MeshRefinement>();
  const double density = mean_density(block, reaching);
  const double cubes = block.volume * density, squares = block.area * std::pow(density, 2.0 / 3);
  const double tetrahedra = std::max({inside * cubes + along_surface * squares, of_one_layer * squares, least});
  constexpr double around_an_inner_node = 6.9, nodes_on_a_square = 0.9, corners = 5;
  return {tetrahedra, tetrahedra / around_an_inner_node + nodes_on_a_square * squares + corners};
}

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

BlockToMesh block_to_mesh(const Project& project, const Block& block, const Box& solid_box) {
  const Solid& solid = project.solids[static_cast<std::size_t>(block.solid)];
  const auto named = std::ranges::find(project.blocks, block.name, &BlockOverride::name);
  const BlockOverride* wanted = named == project.blocks.end() ? nullptr : &*named;
  const BodyKind body = wanted_body(block, solid, wanted);
  const bool coarse = corners_suffice(body, solid, wanted, std::holds_alternative<TerrainShape>(solid.shape));
  const double usual = solid.mesh_size.value_or(project.mesh.size.value_or(solid_box.sizes().maxCoeff() / 10));
  Box box;
  for (const Vec3& node : block.mesh.nodes) box.extend(node);
  return {body,
          coarse ? solid_box.diagonal().norm() : (wanted && wanted->mesh_size ? *wanted->mesh_size : usual),
          !coarse,
          block.volume,
          surface_area(block),
          box.min(),
          box.max()};
}

}  // namespace

MeshEstimate mesh_estimate(std::span<const BlockToMesh> blocks, std::span<const MeshRefinement> refinements) {
  MeshEstimate estimate;
  double largest = 0;
  for (const BlockToMesh& block : blocks) {
    const Counts counts = counts_of(block, refinements);
    estimate.tetrahedra += counts.tetrahedra;
    estimate.nodes += counts.nodes;
    estimate.unknowns += unknowns_of(block.body, counts.nodes);
    largest = std::max(largest, counts.tetrahedra);
  }
  // gmsh has one block at a time, the program keeps them all.
  constexpr double bytes_of_gmsh = 75e6, bytes_at_work = 550, bytes_kept = 60;
  estimate.bytes = bytes_of_gmsh + bytes_at_work * largest + bytes_kept * estimate.tetrahedra;
  constexpr double seconds_a_tetrahedron = 45e-6, seconds_a_block = 5e-3;
  estimate.seconds = seconds_a_tetrahedron * estimate.tetrahedra + seconds_a_block * static_cast<double>(blocks.size());
  return estimate;
}

MeshEstimate mesh_estimate(const Project& project, const BlockSystem& cut) {
  const ExtentOfSolids solids = extents(cut);
  std::vector<BlockToMesh> blocks;
  for (const Block& block : cut.blocks) blocks.push_back(block_to_mesh(project, block, solids.at(block.solid)));
  return mesh_estimate(blocks, project.mesh.refinements);
}

void require_a_mesh_that_fits(const Project& project, const MeshEstimate& estimate) {
  if (estimate.tetrahedra <= project.mesh.most_tetrahedra) return;
  throw InputError("/mesh/most_tetrahedra",
                   "the mesh would have about " + significant(estimate.tetrahedra, 2) + " tetrahedra, more than " +
                       number_text(project.mesh.most_tetrahedra),
                   "make mesh sizes larger, blocks rigid or affine, or allow more");
}

}  // namespace talus
