#include "verification/failed_scene.hpp"

#include <algorithm>
#include <map>
#include <system_error>

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "io/whole_file.hpp"
#include "mesh/surface.hpp"
#include "verification/smaller_scene.hpp"

namespace talus {

namespace {

constexpr int most_runs = 30;  // to make a scene smaller

/// The nodes of the surface alone.
PolyhedronShape polyhedron_of(const Block& block) {
  PolyhedronShape shape;
  std::map<int, int> numbers;
  for (const SurfaceTriangle& triangle : block.surface) {
    std::vector<int>& face = shape.faces.emplace_back();
    for (const int node : triangle.nodes) {
      const auto [number, is_new] = numbers.try_emplace(node, static_cast<int>(shape.vertices.size()));
      if (is_new) shape.vertices.push_back(block.mesh.nodes[node]);
      face.push_back(number->second);
    }
  }
  return shape;
}

Solid solid_of(const Block& block, const Project& project) {
  Solid solid{block.name, polyhedron_of(block), project.materials[block.material].name, block.body, {}};
  if (block.body == BodyKind::tetrahedra) solid.mesh_size = make_surface(block.mesh.nodes, block.surface).size;
  return solid;
}

}  // namespace

Project project_of(const CaseScene& scene) {
  Project project = scene.project;
  if (project.solids.empty())
    for (const Block& block : scene.system.blocks) project.solids.push_back(solid_of(block, project));
  return project;
}

std::filesystem::path write_failed_scene(const std::filesystem::path& folder, const HardCase& scene, const Trial& trial,
                                         const TrialOptions& options, Progress& progress) {
  const std::optional<FaultKind> kind = law_broken(trial);
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw InputError(folder.string(), failure.message(), "choose another folder");
  const CaseScene built = scene.build();
  Project project = project_of(kind ? smaller_scene(built, *kind, most_runs, options, progress) : built);
  project.name = scene.name;
  std::string text = "// " + scene.name + ": " + scene.title + '\n';
  if (kind) text += "// Made smaller as long as this fails: " + std::string(to_string(*kind)) + '\n';
  for (std::string fault : faults(trial)) {
    std::replace(fault.begin(), fault.end(), '\n', ' ');
    text += "// - " + fault + '\n';
  }
  std::string file_name = scene.name + ".talus";
  std::replace(file_name.begin(), file_name.end(), ':', '-');
  const std::filesystem::path file = folder / file_name;
  replace_whole_file(file, text + write_project(project));
  return file;
}

}  // namespace talus
