#include "geometry/mesher/blocks/splinters.hpp"

#include <algorithm>
#include <sstream>

#include "geometry/mesher/solid_size.hpp"
#include "geometry/splinters_found.hpp"

namespace talus {
namespace {

bool is_splinter(const CutBlock& block, const MesherJob& job, const ImportedModel& model) {
  const auto solid = static_cast<std::size_t>(block.solid);
  return block.thickness() < job.splinter_thickness.value_or(least_thickness(job.solids[solid], model.solids[solid]));
}

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

void refuse_splinters(const std::vector<NamedBlock>& blocks, const MesherJob& job, const ImportedModel& model) {
  std::vector<Splinter> splinters;
  for (const NamedBlock& block : blocks)
    if (is_splinter(block.shape, job, model)) splinters.push_back(told(block.shape, model.origin));
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

Position thinnest_splinter(std::vector<NamedBlock>& blocks, const MesherJob& job, const ImportedModel& model) {
  Position thinnest = blocks.end();
  for (Position block = blocks.begin(); block != blocks.end(); ++block) {
    if (!is_splinter(block->shape, job, model)) continue;
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
  if (job.splinter_rule == SplinterRule::refuse) refuse_splinters(blocks, job, model);
  std::vector<MesherSplinter> splinters;
  for (;;) {
    const Position thinnest = thinnest_splinter(blocks, job, model);
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
