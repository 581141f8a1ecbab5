#include "geometry/mesher/blocks/block_cutter.hpp"

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "geometry/mesher/cells/cell_cutter.hpp"
#include "geometry/mesher/solid_cutter.hpp"

namespace talus {
namespace {

/// Of each cut whose joints end, how many of them divide rock.
std::vector<MesherEndings> endings_of(const MesherJob& job, const std::set<std::pair<int, int>>& dividing) {
  std::vector<MesherEndings> endings;
  for (std::size_t c = 0; c < job.cuts.size(); ++c) {
    const MesherCut& cut = job.cuts[c];
    const bool ends = !cut.ends_at.empty() || std::any_of(cut.joints.begin(), cut.joints.end(),
                                                          [](const auto& joint) { return !joint.outline.empty(); });
    if (!ends) continue;
    MesherEndings told;
    told.cut = static_cast<int>(c);
    told.joints = cut.joints.empty() ? cut.count : static_cast<int>(cut.joints.size());
    told.dividing = static_cast<int>(
        std::count_if(dividing.begin(), dividing.end(), [&](const auto& joint) { return joint.first == told.cut; }));
    endings.push_back(told);
  }
  return endings;
}

void check_hits(const MesherJob& job, const std::vector<bool>& hit) {
  for (std::size_t c = 0; c < job.cuts.size(); ++c) {
    if (hit[c] || job.cuts[c].may_miss) continue;
    throw InputError(job.cuts[c].title,
                     "misses every solid" + std::string(job.cuts[c].solids.empty() ? "" : " it is limited to"),
                     "move its point \"through\", or remove it");
  }
}

void append(std::vector<CutBlock>& blocks, const std::vector<CutBlock>& more) {
  blocks.insert(blocks.end(), more.begin(), more.end());
}

void cut_as_cells(const MesherJob& job, const ImportedModel& model, int solid, const std::vector<ActingJoint>& joints,
                  CutModel& result, std::vector<bool>& hit, int& next_tag, const std::function<void(double)>& report) {
  CutCells cut = cut_cells(job, model, solid, joints, next_tag, report);
  for (const CutBlock& block : cut.blocks)
    if (!block.facets.empty()) next_tag = std::min(next_tag, block.facets.begin()->first - 1);
  append(result.blocks, cut.blocks);
  result.cells.emplace(solid, std::move(cut.solid));
  for (std::size_t k = 0; k < joints.size(); ++k)
    if (cut.hit[k]) hit[static_cast<std::size_t>(joints[k].cut)] = true;
}

}  // namespace

CutModel cut_solids(const MesherJob& job, const ImportedModel& model,
                    const std::function<void(double, std::string_view)>& report) {
  Eigen::AlignedBox3d bounds;
  for (const ImportedSolid& solid : model.solids) bounds.extend(solid.bounds);
  constexpr double rounding = 1e-10;
  CutModel result{PlaneTable(rounding * bounds.diagonal().norm()), {}, {}, {}};
  std::vector<bool> hit(job.cuts.size(), false);
  std::set<std::pair<int, int>> dividing;
  int next_tag = -1;  // facets of cells have negative ones
  for (std::size_t s = 0; s < job.solids.size(); ++s) {
    if (!model.solids[s].is_body()) continue;
    const int solid = static_cast<int>(s);
    const auto report_part = [&](double part) {
      report((static_cast<double>(s) + part) / static_cast<double>(job.solids.size()), "cutting " + job.solids[s].name);
    };
    report_part(0);
    const std::vector<ActingJoint> joints = acting_joints(job, solid, model.origin, model.solids[s].bounds);
    if (model.solids[s].is_cells()) {
      cut_as_cells(job, model, solid, joints, result, hit, next_tag, report_part);
      continue;
    }
    SolidCutter cutter(job, model, solid, result.planes);
    for (const ActingJoint& joint : joints)
      if (cutter.add(joint)) hit[static_cast<std::size_t>(joint.cut)] = true;
    append(result.blocks, cutter.cut());
    dividing.insert(cutter.dividing().begin(), cutter.dividing().end());
  }
  check_hits(job, hit);
  result.endings = endings_of(job, dividing);
  return result;
}

}  // namespace talus
