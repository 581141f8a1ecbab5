#include "geometry/mesher/block_names.hpp"

#include <gmsh.h>

#include <map>
#include <sstream>

#include "base/error.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

std::string title_of(const MesherJob& job, std::size_t index) {
  const MesherOverride& wanted = job.overrides[index];
  return "block override " + std::to_string(index + 1) + (wanted.name.empty() ? "" : " (" + wanted.name + ")");
}

/// Inside or on the border. gmsh's own test of a point answers for surfaces only; a point's intersection with the
/// volume is exact for curved faces too.
bool holds(int volume, const Vec3& point) {
  Vec3 low, high;
  occ::getBoundingBox(3, volume, low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
  if ((point.array() < low.array()).any() || (point.array() > high.array()).any()) return false;
  const int tag = occ::addPoint(point.x(), point.y(), point.z());
  gmsh::vectorpair common;
  std::vector<gmsh::vectorpair> ancestry;
  occ::intersect({{0, tag}}, {{3, volume}}, common, ancestry, -1, true, false);
  if (common.empty()) return false;
  occ::remove(common);
  return true;
}

std::size_t block_at(const MesherJob& job, const ImportedModel& model, const CutModel& cut,
                     const std::vector<NamedBlock>& names, std::size_t index) {
  const Vec3 point = job.overrides[index].at - model.origin;
  std::vector<std::size_t> found;
  for (std::size_t b = 0; b < cut.blocks.size(); ++b) {
    if (holds(cut.blocks[b].volume_tag, point)) found.push_back(b);
  }
  if (found.empty()) {
    throw InputError(title_of(job, index), "its point \"at\" lies in no block",
                     "move it inside the block that is meant");
  }
  if (found.size() > 1) {
    throw InputError(title_of(job, index),
                     "its point \"at\" lies on the border of " + names[found[0]].name + " and " + names[found[1]].name,
                     "move it inside the block that is meant");
  }
  return found.front();
}

void check_names_differ(const std::vector<NamedBlock>& names) {
  std::map<std::string, int> count;
  for (const NamedBlock& block : names) {
    if (++count[block.name] > 1) {
      throw InputError("block " + block.name, "two blocks have this name", "give one of them another name");
    }
  }
}

}  // namespace

std::vector<NamedBlock> name_blocks(const MesherJob& job, const ImportedModel& model, const CutModel& cut) {
  std::vector<int> pieces(job.solids.size(), 0), next(job.solids.size(), 0);
  for (const CutBlock& block : cut.blocks) ++pieces[static_cast<std::size_t>(block.solid)];
  std::vector<NamedBlock> names;
  for (const CutBlock& block : cut.blocks) {
    const auto s = static_cast<std::size_t>(block.solid);
    const std::string& solid = job.solids[s].name;
    names.push_back({pieces[s] == 1 ? solid : solid + "." + std::to_string(++next[s]), -1,
                     mesh_size_of(job.solids[s], model.solids[s])});
  }
  const std::vector<NamedBlock> automatic = names;
  for (std::size_t i = 0; i < job.overrides.size(); ++i) {
    NamedBlock& block = names[block_at(job, model, cut, automatic, i)];
    if (block.block_override >= 0) {
      throw InputError(title_of(job, i),
                       "lies in the same block as " + title_of(job, static_cast<std::size_t>(block.block_override)),
                       "keep one of them");
    }
    block.block_override = static_cast<int>(i);
    const MesherOverride& wanted = job.overrides[i];
    if (!wanted.name.empty()) block.name = wanted.name;
    if (wanted.mesh_size) block.mesh_size = *wanted.mesh_size;
  }
  check_names_differ(names);
  return names;
}

}  // namespace talus
