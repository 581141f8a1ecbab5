#include "geometry/mesher/shape_import.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "geometry/mesher/cad_file.hpp"
#include "geometry/mesher/combined_solid.hpp"
#include "geometry/mesher/flat_bodies.hpp"
#include "geometry/mesher/occ_volumes.hpp"
#include "geometry/mesher/placement.hpp"
#include "geometry/mesher/polyhedron.hpp"
#include "geometry/mesher/surface_file.hpp"
#include "geometry/mesher/surfaces/mended_surface.hpp"
#include "model/number_text.hpp"
#include "model/polyhedron.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

std::string place_of(const MesherSolid& solid) { return "solid " + solid.name; }

/// OpenCASCADE's time to cut a solid grows with the square of its faces: at ten thousand it takes a minute, cells two
/// seconds.
constexpr std::size_t most_faces_of_volume = 1000;

/// As files of triangles come: closed, and crossing itself nowhere, or found not to be.
ImportedSolid as_triangles(const PolyhedronShape& local, const Vec3& origin) {
  MendedSurface surface = mended({local.vertices, local.faces});
  ImportedSolid imported;
  imported.triangles = std::move(surface.surface);
  imported.findings = std::move(surface.findings);
  for (SurfaceFinding& finding : imported.findings) finding.where += origin;
  imported.bounds = bounds_of(imported.triangles);
  imported.volume = volume_of(imported.triangles);
  return imported;
}

ImportedSolid make_polyhedron(const MesherSolid& solid, const Vec3& origin) {
  PolyhedronShape local = solid.polyhedron;
  for (Vec3& vertex : local.vertices) vertex -= origin;
  local = flattened(std::move(local), place_of(solid));
  const double enclosed = signed_volume(local);
  ImportedSolid imported;
  if (solid.corners_suffice && is_convex(local)) {
    for (const Vec3& vertex : local.vertices) imported.bounds.extend(vertex);
    imported.volume = enclosed;
    imported.convex = std::move(local);
    return imported;
  }
  if (local.faces.size() > most_faces_of_volume) return as_triangles(local, origin);
  try {
    imported.volumes = {add_polyhedron(local)};
    imported.volume = volume_of(imported.volumes);
  } catch (const std::string&) {
    imported.volume = 0;
  }
  constexpr double same = 1e-9;
  if (std::abs(imported.volume - enclosed) > same * enclosed) {
    throw InputError(place_of(solid), "the faces of the polyhedron cross each other", "correct its vertices");
  }
  // OpenCASCADE's own bounding box is wider by its tolerance.
  for (const Vec3& vertex : local.vertices) imported.bounds.extend(vertex);
  return imported;
}

/// Corners that far are damaged; cutting what reaches there takes seconds, and has no digits left for the rest.
void check_extent(const MesherSolid& solid, const Eigen::AlignedBox3d& bounds) {
  constexpr double farthest = 1e8;  // m
  const double extent = bounds.isEmpty() ? 0 : bounds.sizes().maxCoeff();
  if (extent <= farthest) return;
  throw InputError(place_of(solid), "is " + significant(extent, 2) + " m large, more than the Earth",
                   "correct its corners, and give them in metres");
}

/// What a file holds, in the project's coordinates, and the box around what the project itself tells.
ImportedSolid read(const MesherSolid& solid) {
  ImportedSolid imported;
  if (has_surface_file(solid)) {
    MendedSurface surface = read_surface(solid);
    imported.triangles = std::move(surface.surface);
    imported.findings = std::move(surface.findings);
    imported.bounds = bounds_of(imported.triangles);
  } else if (!solid.file.empty()) {
    imported.volumes = read_cad(solid);
    imported.bounds = bounds_of(imported.volumes);
    if (imported.volumes.size() > 1)
      imported.findings.push_back({SurfaceFinding::Kind::several_bodies, static_cast<int>(imported.volumes.size()),
                                   imported.bounds.center(), true});
  } else {
    for (const Vec3& vertex : solid.polyhedron.vertices) imported.bounds.extend(vertex);
  }
  return imported;
}

void shift(ImportedSolid& imported, const Vec3& origin) {
  gmsh::vectorpair shapes;
  for (const int tag : imported.volumes) shapes.emplace_back(3, tag);
  if (!shapes.empty()) occ::translate(shapes, -origin.x(), -origin.y(), -origin.z());
  for (Vec3& vertex : imported.triangles.vertices) vertex -= origin;
  imported.bounds.translate(-origin);
}

void measure(ImportedSolid& imported) {
  if (imported.volumes.empty())
    imported.volume = volume_of(imported.triangles);
  else
    imported.volume = volume_of(imported.volumes);
}

void check_sound(const MesherSolid& solid, const ImportedSolid& imported) {
  for (const SurfaceFinding& finding : imported.findings)
    if (is_fatal(finding)) throw unsound(solid.file.empty() ? place_of(solid) : solid.file_as_written, finding);
}

ImportedSolid make_combined(const MesherSolid& solid, const std::vector<MesherSolid>& solids, ImportedModel& model,
                            ImportPurpose purpose) {
  for (const int part : solid.combined->solids)
    check_sound(solids[static_cast<std::size_t>(part)], model.solids[static_cast<std::size_t>(part)]);
  ImportedSolid made = combine(*solid.combined, model, purpose == ImportPurpose::look, place_of(solid));
  const MesherPlacement placement = relative_to(model.origin, solid.placement);
  place_volumes(placement, made.volumes);
  for (Vec3& vertex : made.triangles.vertices) vertex = placed(placement, vertex);
  made.bounds = made.volumes.empty() ? bounds_of(made.triangles) : bounds_of(made.volumes);
  measure(made);
  return made;
}

/// Triangles that lie in few planes become a volume that OpenCASCADE can cut; others are cut as cells.
void make_volumes(ImportedSolid& imported) {
  constexpr std::size_t most_faces = 300;
  if (!imported.volumes.empty() || imported.triangles.empty()) return;
  imported.volumes = add_flat_bodies(imported.triangles, most_faces);
  if (imported.volumes.empty()) return;
  imported.triangles = {};
  measure(imported);
}

/// Whole metres, so that taking it off and putting it back costs no digit.
Vec3 rounded_centre(const Eigen::AlignedBox3d& bounds) { return bounds.center().array().round(); }

}  // namespace

ImportedModel import_solids(const std::vector<MesherSolid>& solids, ImportPurpose purpose,
                            const std::function<void(double, std::string_view)>& report) {
  const auto begin = [&](std::size_t step, std::string_view word, const MesherSolid& solid) {
    report(static_cast<double>(step) / static_cast<double>(2 * solids.size()), std::string(word) + " " + solid.name);
  };
  ImportedModel model;
  model.solids.resize(solids.size());
  std::vector<std::size_t> order(solids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return is_iges(solids[i]); });
  Eigen::AlignedBox3d bounds;
  for (std::size_t done = 0; done < order.size(); ++done) {
    const std::size_t i = order[done];
    begin(done, solids[i].file.empty() ? "placing" : words_of_reading, solids[i]);
    model.solids[i] = read(solids[i]);
    check_extent(solids[i], model.solids[i].bounds);
    bounds.extend(model.solids[i].bounds);
  }
  model.origin = rounded_centre(bounds);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    ImportedSolid& imported = model.solids[i];
    if (solids[i].combined) {
      begin(solids.size() + i, "combining", solids[i]);
      imported = make_combined(solids[i], solids, model, purpose);
    } else if (!solids[i].polyhedron.faces.empty()) {
      imported = make_polyhedron(solids[i], model.origin);
    } else {
      shift(imported, model.origin);
      measure(imported);
    }
  }
  if (purpose == ImportPurpose::cut) {
    for (std::size_t i = 0; i < solids.size(); ++i) {
      if (solids[i].is_part) {
        model.solids[i] = {};
        continue;
      }
      report(1, "checking " + solids[i].name);
      check_sound(solids[i], model.solids[i]);
      make_volumes(model.solids[i]);
    }
  }
  occ::synchronize();
  return model;
}

}  // namespace talus
