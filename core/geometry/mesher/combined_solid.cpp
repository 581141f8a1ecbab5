#include "geometry/mesher/combined_solid.hpp"

#include <gmsh.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "geometry/mesher/occ_volumes.hpp"
#include "geometry/mesher/surfaces/surface_boolean.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

gmsh::vectorpair shapes_of(const std::vector<int>& volumes) {
  gmsh::vectorpair shapes;
  for (const int tag : volumes) shapes.emplace_back(3, tag);
  return shapes;
}

gmsh::vectorpair take(ImportedSolid& part, bool keep) {
  gmsh::vectorpair shapes = shapes_of(part.volumes);
  if (keep) {
    gmsh::vectorpair copies;
    occ::copy(shapes, copies);
    return copies;
  }
  part.volumes.clear();
  return shapes;
}

gmsh::vectorpair operate(CombineOperation operation, const gmsh::vectorpair& first, const gmsh::vectorpair& second) {
  gmsh::vectorpair result;
  std::vector<gmsh::vectorpair> ancestry;
  switch (operation) {
    case CombineOperation::subtract:
      occ::cut(first, second, result, ancestry);
      break;
    case CombineOperation::intersect:
      occ::intersect(first, second, result, ancestry);
      break;
    case CombineOperation::unite:
      occ::fuse(first, second, result, ancestry);
      break;
  }
  return result;
}

ImportedSolid combine_volumes(const MesherCombination& combination, ImportedModel& model, bool keep_parts,
                              const std::string& place) {
  const auto part = [&](std::size_t k) -> ImportedSolid& {
    return model.solids[static_cast<std::size_t>(combination.solids[k])];
  };
  gmsh::vectorpair sum = take(part(0), keep_parts);
  for (std::size_t k = 1; k < combination.solids.size() && !sum.empty(); ++k)
    sum = operate(combination.operation, sum, take(part(k), keep_parts));
  ImportedSolid solid;
  for (const auto& [dimension, tag] : sum)
    if (dimension == 3) solid.volumes.push_back(tag);
  if (solid.volumes.empty()) throw InputError(place, "nothing is left of it", "move its parts so that they share rock");
  if (solid.volumes.size() > 1)
    solid.findings.push_back({SurfaceFinding::Kind::several_bodies, static_cast<int>(solid.volumes.size()),
                              bounds_of(solid.volumes).center() + model.origin, true});
  return solid;
}

ImportedSolid combine_surfaces(const MesherCombination& combination, const ImportedModel& model,
                               const std::string& place) {
  std::vector<TriangleSolid> parts;
  for (const int i : combination.solids) {
    const ImportedSolid& part = model.solids[static_cast<std::size_t>(i)];
    parts.push_back(part.volumes.empty() ? part.triangles : tessellated(part.volumes));
  }
  MendedSurface surface = combined(combination.operation, parts, place);
  ImportedSolid solid;
  solid.triangles = std::move(surface.surface);
  for (SurfaceFinding& finding : surface.findings) {
    finding.where += model.origin;
    if (is_fatal(finding)) throw unsound(place, finding);
    if (finding.kind == SurfaceFinding::Kind::several_bodies) solid.findings.push_back(finding);
  }
  return solid;
}

}  // namespace

ImportedSolid combine(const MesherCombination& combination, ImportedModel& model, bool keep_parts,
                      const std::string& place) {
  const auto has_volumes = [&](int i) { return !model.solids[static_cast<std::size_t>(i)].volumes.empty(); };
  if (std::all_of(combination.solids.begin(), combination.solids.end(), has_volumes))
    return combine_volumes(combination, model, keep_parts, place);
  return combine_surfaces(combination, model, place);
}

}  // namespace talus
