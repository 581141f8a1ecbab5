#include "geometry/mesher_solids.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/units.hpp"
#include "model/solid_shape.hpp"

namespace talus {
namespace {

MesherPlacement placement_of(const Solid& solid, const Vec3& origin) {
  MesherPlacement placement;
  placement.origin = origin;
  placement.move = solid.move;
  if (!solid.turn) return placement;
  placement.axis = solid.turn->axis.normalized();
  placement.about = solid.turn->about;
  placement.angle = radians(solid.turn->angle);
  return placement;
}

void read_from(MesherSolid& job, const std::string& path, const std::filesystem::path& folder) {
  job.file = std::filesystem::absolute(folder / path).string();
  job.file_as_written = path;
  if (!std::filesystem::is_regular_file(job.file))
    throw InputError(path, "there is no such file", "correct the path of solid " + job.name);
}

/// The solids that are combined stand before: the project keeps to its rules.
MesherCombination combination_of(const CombinedShape& shape, std::vector<MesherSolid>& before) {
  MesherCombination combination{shape.operation, {}};
  for (const std::string& name : shape.solids) {
    const auto part = std::find_if(before.begin(), before.end(), [&](const auto& solid) { return solid.name == name; });
    if (part == before.end())
      throw InputError("solid " + name, "is not there to be combined", "put it before the solid that is made of it");
    part->is_part = true;
    combination.solids.push_back(static_cast<int>(part - before.begin()));
  }
  return combination;
}

}  // namespace

std::vector<MesherSolid> mesher_solids(const std::vector<Solid>& solids, const Vec3& origin,
                                       const std::filesystem::path& folder) {
  std::vector<MesherSolid> jobs;
  for (const Solid& solid : solids) {
    MesherSolid job;
    job.name = solid.name;
    job.mesh_size = solid.mesh_size;
    job.placement = placement_of(solid, origin);
    if (auto polyhedron = polyhedron_of(solid)) job.polyhedron = std::move(*polyhedron);
    if (const std::string* path = file_of(solid.shape)) read_from(job, *path, folder);
    if (const auto* file = std::get_if<FileShape>(&solid.shape)) job.scale = file->scale;
    if (const auto* terrain = std::get_if<TerrainShape>(&solid.shape))
      job.terrain = MesherTerrain{terrain->base, terrain->tolerance};
    if (const auto* combined = std::get_if<CombinedShape>(&solid.shape)) job.combined = combination_of(*combined, jobs);
    jobs.push_back(std::move(job));
  }
  return jobs;
}

}  // namespace talus
