#include "geometry/mesher/blocks/splinters.hpp"

#include <algorithm>
#include <sstream>

#include "geometry/mesher/solid_size.hpp"
#include "geometry/splinters_found.hpp"

namespace talus {
namespace {

/// What is too thin or too small to be a block, by its solid.
class SplinterLimits {
 public:
  SplinterLimits(const std::vector<NamedBlock>& blocks, const MesherJob& job, const ImportedModel& model) {
    std::vector<std::vector<double>> volumes(job.solids.size());
    for (const NamedBlock& block : blocks)
      volumes[static_cast<std::size_t>(block.shape.solid)].push_back(block.shape.volume);
    for (std::size_t s = 0; s < job.solids.size(); ++s) {
      thickness_.push_back(job.splinter_thickness.value_or(least_thickness(job.solids[s], model.solids[s])));
      volume_.push_back(volumes[s].empty() ? 0 : job.chip_volume * median(volumes[s]));
    }
  }
  bool are_undercut_by(const NamedBlock& block) const {
    const auto solid = static_cast<std::size_t>(block.shape.solid);
    const bool is_named = block.block_override >= 0;
    return block.shape.thickness() < thickness_[solid] || (!is_named && block.shape.volume < volume_[solid]);
  }

 private:
  static double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }
  std::vector<double> thickness_, volume_;  // m, m³
};

MesherSplinter told(const CutBlock& block, const Vec3& origin) {
  MesherSplinter splinter;
  splinter.solid = block.solid;
  splinter.where = block.centroid + origin;
  splinter.volume = block.volume;
  splinter.thickness = block.thickness();
  return splinter;
}

std::string described(const Splinter& splinter) {
  std::ostringstream text;
  text.precision(3);
  text << splinter.thickness << " m thick around " << coordinates(splinter.where) << " (" << splinter.volume << " m³)";
  return text.str();
}

void refuse_splinters(const std::vector<NamedBlock>& blocks, const SplinterLimits& limits, const MesherJob& job,
                      const Vec3& origin) {
  std::vector<Splinter> splinters;
  for (const NamedBlock& block : blocks)
    if (limits.are_undercut_by(block)) splinters.push_back(told(block.shape, origin));
  if (splinters.empty()) return;
  const int solid = splinters.front().solid;
  const bool one_solid = std::all_of(splinters.begin(), splinters.end(),
                                     [&](const Splinter& splinter) { return splinter.solid == solid; });
  std::string problem = "the cuts leave a splinter ";
  if (splinters.size() > 1) problem = "the cuts leave " + std::to_string(splinters.size()) + " splinters: ";
  for (std::size_t i = 0; i < splinters.size(); ++i) problem += (i == 0 ? "" : ", ") + described(splinters[i]);
  const std::string& name = job.solids[static_cast<std::size_t>(solid)].name;
  throw SplintersFound(one_solid ? "solid " + name : "several solids", problem,
                       "move a cut so that the piece goes or becomes thicker, or let \"splinters\" drop or merge it",
                       splinters);
}

using Position = std::vector<NamedBlock>::iterator;

Position thinnest_splinter(std::vector<NamedBlock>& blocks, const SplinterLimits& limits) {
  Position thinnest = blocks.end();
  for (Position block = blocks.begin(); block != blocks.end(); ++block) {
    if (!limits.are_undercut_by(*block)) continue;
    if (thinnest == blocks.end() || block->shape.thickness() < thinnest->shape.thickness()) thinnest = block;
  }
  return thinnest;
}

/// Blocks of other solids share no faces with it.
Position largest_neighbour(std::vector<NamedBlock>& blocks, Position splinter) {
  Position largest = blocks.end();
  double most = 0;
  for (Position other = blocks.begin(); other != blocks.end(); ++other) {
    if (other == splinter) continue;
    const double area = shared_area(splinter->shape, other->shape);
    if (area > most) largest = other;
    most = std::max(most, area);
  }
  return largest;
}

}  // namespace

std::string coordinates(const Vec3& point) {
  std::ostringstream text;
  text.precision(9);  // centimetres in the coordinates of a survey
  text << "(" << point.x() << ", " << point.y() << ", " << point.z() << ")";
  return text.str();
}

std::vector<MesherSplinter> treat_splinters(std::vector<NamedBlock>& blocks, const MesherJob& job,
                                            const ImportedModel& model) {
  const SplinterLimits limits(blocks, job, model);
  if (job.splinter_rule == SplinterRule::refuse) refuse_splinters(blocks, limits, job, model.origin);
  std::vector<MesherSplinter> splinters;
  for (;;) {
    const Position thinnest = thinnest_splinter(blocks, limits);
    if (thinnest == blocks.end()) return splinters;
    MesherSplinter splinter = told(thinnest->shape, model.origin);
    const Position neighbour =
        job.splinter_rule == SplinterRule::merge ? largest_neighbour(blocks, thinnest) : blocks.end();
    splinter.fate = neighbour == blocks.end() ? Splinter::Fate::dropped : Splinter::Fate::merged;
    if (neighbour != blocks.end()) {
      splinter.merged_into = neighbour->name;
      join(neighbour->shape, thinnest->shape);
    }
    // What had become part of this one shares its fate.
    for (MesherSplinter& earlier : splinters) {
      if (earlier.merged_into != thinnest->name) continue;
      earlier.fate = splinter.fate;
      earlier.merged_into = splinter.merged_into;
    }
    splinters.push_back(splinter);
    blocks.erase(thinnest);
  }
}

}  // namespace talus
