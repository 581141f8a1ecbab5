#include "geometry/mesher/cells/cell_cutter.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <tuple>

#include "base/error.hpp"
#include "geometry/mesher/cells/set_numbers.hpp"
#include "geometry/mesher/cells/solid_cells.hpp"

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

void add_cell(CutBlock& block, int cell, const CellComplex& complex) {
  const Cell& shape = complex.cells()[static_cast<std::size_t>(cell)];
  Vec3 middle = Vec3::Zero();
  int corners = 0;
  for (const CellFace& face : shape) {
    for (int corner : face.corners) {
      block.bounds.extend(complex.vertex(corner));
      middle += complex.vertex(corner);
      ++corners;
    }
  }
  const double volume = volume_of(shape, complex.vertices());
  block.cells.push_back(cell);
  block.volume += volume;
  block.centroid += volume * middle / corners;  // near enough for an order and a place
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

std::vector<CutBlock> glued(const CellSolid& solid, int index, int first_tag) {
  const std::vector<int> block_of = blocks_of_cells(solid);
  std::vector<CutBlock> blocks(static_cast<std::size_t>(1 + *std::max_element(block_of.begin(), block_of.end())));
  for (std::size_t c = 0; c < block_of.size(); ++c)
    add_cell(blocks[static_cast<std::size_t>(block_of[c])], static_cast<int>(c), solid.complex);
  for (CutBlock& block : blocks) {
    block.solid = index;
    block.centroid /= block.volume;
  }
  add_facets(blocks, block_of, solid, first_tag);
  return blocks;
}

}  // namespace

CutCells cut_cells(const MesherJob& job, const ImportedModel& model, int solid, const std::vector<ActingJoint>& joints,
                   int first_tag) {
  const auto s = static_cast<std::size_t>(solid);
  const std::string place = "solid " + job.solids[s].name;
  SolidCells cells = cells_of(model.solids[s].triangles, place);
  CutCells result;
  result.solid.complex = std::move(cells.complex);
  result.solid.joints.assign(static_cast<std::size_t>(cells.flat_faces), -1);
  for (const ActingJoint& joint : joints) {
    const MesherCut& cut = job.cuts[static_cast<std::size_t>(joint.cut)];
    if (joint.ends()) {
      throw InputError(cut.title, "ends, and " + place + " is cut along planes without end alone: it has many faces",
                       "limit the cut to other \"solids\", or let it go through");
    }
    const int mark = static_cast<int>(result.solid.joints.size());
    result.hit.push_back(result.solid.complex.cut(joint.plane, mark, cells.flat_faces));
    result.solid.joints.push_back(cut.joint);
  }
  result.solid.across = cells_across(result.solid.complex);
  result.blocks = glued(result.solid, solid, first_tag);
  check_volume(result.blocks, model.solids[s].volume, job.solids[s].name);
  sort_by_place(result.blocks, model.solids[s].longest_side());
  return result;
}

}  // namespace talus
