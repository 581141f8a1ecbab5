#include "geometry/mesher/cells/cell_cutter.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <tuple>

#include "base/error.hpp"
#include "geometry/mesher/cells/joint_planes.hpp"
#include "geometry/mesher/cells/set_numbers.hpp"
#include "geometry/mesher/cells/solid_cells.hpp"
#include "geometry/mesher/solid_size.hpp"

namespace talus {
namespace {

/// The number of the block that each cell is part of.
std::vector<int> blocks_of_cells(const CellSolid& solid) {
  const std::vector<Cell>& cells = solid.complex.cells();
  DisjointSets blocks;
  blocks.reset(static_cast<int>(cells.size()));
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (std::size_t f = 0; f < cells[c].size(); ++f) {
      const int across = solid.across[c][f];
      if (cells[c][f].mark == between_cells && across >= 0) blocks.join(static_cast<int>(c), across);
    }
  }
  return set_numbers(blocks);
}

/// m, about one of its corners, by the divergence theorem.
Vec3 centroid_of(const Cell& cell, const std::vector<Vec3>& vertices) {
  const auto at = [&](int v) -> const Vec3& { return vertices[static_cast<std::size_t>(v)]; };
  const Vec3& origin = at(cell.front().corners.front());
  double sixfold = 0;
  Vec3 moment = Vec3::Zero();
  for (const CellFace& face : cell)
    for (std::size_t k = 1; k + 1 < face.corners.size(); ++k) {
      const Vec3 a = at(face.corners[0]) - origin, b = at(face.corners[k]) - origin,
                 c = at(face.corners[k + 1]) - origin;
      const double part = a.dot(b.cross(c));
      sixfold += part;
      moment += part * (a + b + c) / 4;
    }
  return origin + moment / sixfold;
}

/// Near enough for an order and a place.
Vec3 mean_corner(const Cell& cell, const std::vector<Vec3>& vertices) {
  Vec3 sum = Vec3::Zero();
  int corners = 0;
  for (const CellFace& face : cell)
    for (int corner : face.corners) {
      sum += vertices[static_cast<std::size_t>(corner)];
      ++corners;
    }
  return sum / corners;
}

/// Blocks of convex solids are numbered as those that OpenCASCADE cuts, by their centroids; those of triangulated
/// solids keep the numbers that they always had.
void add_cell(CutBlock& block, int cell, const CellComplex& complex, bool convex) {
  const Cell& shape = complex.cells()[static_cast<std::size_t>(cell)];
  const std::vector<Vec3>& vertices = complex.vertices();
  for (const CellFace& face : shape)
    for (int corner : face.corners) block.bounds.extend(complex.vertex(corner));
  const double volume = volume_of(shape, vertices);
  block.cells.push_back(cell);
  block.volume += volume;
  block.centroid += volume * (convex ? centroid_of(shape, vertices) : mean_corner(shape, vertices));
}

/// A facet for all faces of one mark between the same two blocks, or between a block and the outside.
class FacetTags {
 public:
  explicit FacetTags(int first) : next_(first) {}

  int tag_of(int block, int other, int mark) {
    const auto [low, high] = std::minmax(block, other);
    const auto [known, fresh] = tags_.try_emplace(std::tuple(low, high, mark), next_);
    if (fresh) --next_;
    return known->second;
  }

 private:
  int next_;
  std::map<std::tuple<int, int, int>, int> tags_;
};

void add_facets(std::vector<CutBlock>& blocks, const std::vector<int>& block_of, const CellSolid& solid,
                int first_tag) {
  constexpr int outside = -1;
  FacetTags tags(first_tag);
  for (std::size_t c = 0; c < block_of.size(); ++c) {
    const Cell& cell = solid.complex.cells()[c];
    for (std::size_t f = 0; f < cell.size(); ++f) {
      if (cell[f].mark == between_cells) continue;
      const int across = solid.across[c][f];
      const int other = across < 0 ? outside : block_of[static_cast<std::size_t>(across)];
      if (other == block_of[c]) continue;  // past the end of a joint at a corner of the solid
      CutFacet& facet =
          blocks[static_cast<std::size_t>(block_of[c])].facets[tags.tag_of(block_of[c], other, cell[f].mark)];
      facet.origin = {cell[f].mark, solid.joints[static_cast<std::size_t>(cell[f].mark)]};
      facet.area += area_of(cell[f], solid.complex.vertices()).norm();
    }
  }
}

void check_volume(const std::vector<CutBlock>& blocks, double volume, const std::string& solid) {
  constexpr double allowed = 1e-9;
  double sum = 0;
  for (const CutBlock& block : blocks) sum += block.volume;
  if (std::abs(sum - volume) <= allowed * volume) return;
  std::ostringstream problem;
  problem.precision(12);
  problem << "cutting it gave blocks of " << sum << " m³ from " << volume << " m³";
  throw InputError("solid " + solid, problem.str(), "move cuts that nearly coincide apart or make them one");
}

std::vector<CutBlock> glued(const CellSolid& solid, int index, int first_tag, bool convex) {
  const std::vector<int> block_of = blocks_of_cells(solid);
  std::vector<CutBlock> blocks(static_cast<std::size_t>(1 + *std::max_element(block_of.begin(), block_of.end())));
  for (std::size_t c = 0; c < block_of.size(); ++c)
    add_cell(blocks[static_cast<std::size_t>(block_of[c])], static_cast<int>(c), solid.complex, convex);
  for (CutBlock& block : blocks) {
    block.solid = index;
    block.centroid /= block.volume;
  }
  add_facets(blocks, block_of, solid, first_tag);
  return blocks;
}

/// Throws InputError where another joint has the plane.
void give_joint(KnownPlane& plane, int cut, const MesherJob& job, const std::string& solid) {
  const auto at = [&](int index) -> const MesherCut& { return job.cuts[static_cast<std::size_t>(index)]; };
  if (plane.cut < 0) plane.cut = cut;
  if (at(plane.cut).joint == at(cut).joint) return;
  throw InputError(at(cut).title, "lies on the same plane of " + solid + " as " + at(plane.cut).title,
                   "keep one of the two joints there, or limit the cuts with \"solids\"");
}

}  // namespace

CutCells cut_cells(const MesherJob& job, const ImportedModel& model, int solid, const std::vector<ActingJoint>& joints,
                   int first_tag, const std::function<void(double)>& report) {
  const auto s = static_cast<std::size_t>(solid);
  const std::string place = "solid " + job.solids[s].name;
  const ImportedSolid& imported = model.solids[s];
  const bool convex = !imported.convex.faces.empty();
  SolidCells cells = convex ? cells_of(imported.convex) : cells_of(imported.triangles, place);
  JointPlanes planes;
  if (convex)
    planes =
        JointPlanes(cells.complex.cells().front(), cells.complex.vertices(), least_thickness(job.solids[s], imported));
  CutCells result;
  result.solid.complex = std::move(cells.complex);
  result.solid.joints.assign(static_cast<std::size_t>(cells.flat_faces), -1);
  for (const ActingJoint& joint : joints) {
    const MesherCut& cut = job.cuts[static_cast<std::size_t>(joint.cut)];
    report(static_cast<double>(result.hit.size()) / static_cast<double>(joints.size()));
    if (joint.ends()) {
      throw InputError(cut.title, "ends, and " + place + " is cut along planes without end alone: it has many faces",
                       "limit the cut to other \"solids\", or let it go through");
    }
    if (KnownPlane* under = planes.under(joint.plane)) {
      give_joint(*under, joint.cut, job, place);
      result.solid.joints[static_cast<std::size_t>(under->mark)] = cut.joint;
      result.hit.push_back(true);
      continue;
    }
    const int mark = static_cast<int>(result.solid.joints.size());
    planes.add(joint.plane, joint.cut, mark);
    result.hit.push_back(result.solid.complex.cut(joint.plane, mark, cells.flat_faces));
    result.solid.joints.push_back(cut.joint);
  }
  result.solid.across = cells_across(result.solid.complex);
  result.blocks = glued(result.solid, solid, first_tag, convex);
  check_volume(result.blocks, model.solids[s].volume, job.solids[s].name);
  sort_by_place(result.blocks, model.solids[s].longest_side());
  return result;
}

}  // namespace talus
