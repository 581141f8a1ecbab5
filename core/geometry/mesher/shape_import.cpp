#include "geometry/mesher/shape_import.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "geometry/mesher/polyhedron.hpp"
#include "model/polyhedron.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

std::string place_of(const MesherSolid& solid) { return "solid " + solid.name; }

/// gmsh throws for some unreadable files and gives nothing for others: both end here as no volumes.
std::vector<int> volumes_in_file(const MesherSolid& solid) {
  gmsh::option::setString("Geometry.OCCTargetUnit", "M");  // OpenCASCADE reads millimetres otherwise
  gmsh::option::setNumber("Geometry.OCCScaling", solid.scale);
  gmsh::vectorpair shapes;
  try {
    occ::importShapes(solid.file, shapes, true);
  } catch (const std::string&) {
    shapes.clear();
  }
  if (shapes.empty()) {
    throw InputError(solid.file_as_written, "is not a readable STEP file", "export the solid again as STEP");
  }
  std::vector<int> volumes;
  for (const auto& [dimension, tag] : shapes) {
    if (dimension == 3) volumes.push_back(tag);
  }
  if (volumes.empty()) {
    throw InputError(solid.file_as_written, "holds surfaces but no closed solid", "export a closed solid");
  }
  return volumes;
}

Eigen::AlignedBox3d bounds_of(const std::vector<int>& volumes) {
  Eigen::AlignedBox3d bounds;
  for (int tag : volumes) {
    Vec3 low, high;
    occ::getBoundingBox(3, tag, low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
    bounds.extend(low).extend(high);
  }
  return bounds;
}

double volume_of(const std::vector<int>& volumes) {
  double total = 0;
  for (int tag : volumes) {
    double volume = 0;
    occ::getMass(3, tag, volume);
    total += volume;
  }
  return total;
}

int add_polyhedron(const PolyhedronShape& shape) {
  std::vector<int> points;
  for (const Vec3& vertex : shape.vertices) points.push_back(occ::addPoint(vertex.x(), vertex.y(), vertex.z()));
  std::map<std::pair<int, int>, int> lines;
  std::vector<int> faces;
  for (const std::vector<int>& face : shape.faces) {
    std::vector<int> loop;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int from = face[k], to = face[(k + 1) % face.size()];
      const auto [line, fresh] = lines.try_emplace(std::minmax(from, to), 0);
      if (fresh)
        line->second = occ::addLine(points[static_cast<std::size_t>(from)], points[static_cast<std::size_t>(to)]);
      loop.push_back(line->second);
    }
    faces.push_back(occ::addPlaneSurface({occ::addCurveLoop(loop)}));
  }
  return occ::addVolume({occ::addSurfaceLoop(faces)});
}

ImportedSolid make_polyhedron(const MesherSolid& solid, const Vec3& origin) {
  PolyhedronShape local = solid.polyhedron;
  for (Vec3& vertex : local.vertices) vertex -= origin;
  local = flattened(std::move(local), place_of(solid));
  const double enclosed = signed_volume(local);
  ImportedSolid imported;
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

void shift_file_shape(ImportedSolid& imported, const MesherSolid& solid, const Vec3& origin) {
  gmsh::vectorpair shapes;
  for (int tag : imported.volumes) shapes.emplace_back(3, tag);
  occ::translate(shapes, -origin.x(), -origin.y(), -origin.z());
  imported.bounds.translate(-origin);
  imported.volume = volume_of(imported.volumes);
  if (!(imported.volume > 0)) {
    throw InputError(solid.file_as_written, "holds a solid without volume or inside out", "export a closed solid");
  }
}

/// Whole metres, so that taking it off and putting it back costs no digit.
Vec3 rounded_centre(const Eigen::AlignedBox3d& bounds) { return bounds.center().array().round(); }

}  // namespace

ImportedModel import_solids(const std::vector<MesherSolid>& solids) {
  ImportedModel model;
  model.solids.resize(solids.size());
  Eigen::AlignedBox3d bounds;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (solids[i].file.empty()) {
      for (const Vec3& vertex : solids[i].polyhedron.vertices) bounds.extend(vertex);
    } else {
      model.solids[i].volumes = volumes_in_file(solids[i]);
      model.solids[i].bounds = bounds_of(model.solids[i].volumes);
      bounds.extend(model.solids[i].bounds);
    }
  }
  model.origin = rounded_centre(bounds);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (solids[i].file.empty()) {
      model.solids[i] = make_polyhedron(solids[i], model.origin);
    } else {
      shift_file_shape(model.solids[i], solids[i], model.origin);
    }
  }
  occ::synchronize();
  return model;
}

}  // namespace talus
