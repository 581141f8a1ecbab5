#include "geometry/mesher/cad_file.hpp"

#include <gmsh.h>
#include <sys/time.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "base/error.hpp"
#include "geometry/mesher/brep_text.hpp"
#include "geometry/mesher/occ_volumes.hpp"
#include "geometry/mesher/placement.hpp"
#include "geometry/mesher/sound_edges.hpp"
#include "geometry/mesher/step_text.hpp"
#include "geometry/mesher/surfaces/triangle_file.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

bool is_brep(const MesherSolid& solid) { return ending_of(solid.file) == ".brep"; }

std::string format_of(const MesherSolid& solid) {
  if (is_iges(solid)) return "IGES";
  return is_brep(solid) ? "BREP" : "STEP";
}

/// OpenCASCADE crashes at IGES files that are none: their lines have the letter of their section in column 73.
bool begins_as_iges(const std::string& path) {
  constexpr std::size_t letter = 72;
  std::ifstream file(path);
  std::string line;
  return std::getline(file, line) && line.size() > letter && line[letter] == 'S';
}

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// OpenCASCADE goes round for ever in some damaged files. This program ends where a file takes it many times as long,
/// on the processor, as sound ones of its size do; who started it tells what it was reading.
class ReadingLimit {
 public:
  explicit ReadingLimit(const std::string& path) {
    constexpr double least = 8, of_megabyte = 30;  // s
    std::error_code unknown;
    const auto bytes = std::filesystem::file_size(path, unknown);
    set(least + (unknown ? 0 : of_megabyte * 1e-6 * static_cast<double>(bytes)));
  }
  ~ReadingLimit() { set(0); }
  ReadingLimit(const ReadingLimit&) = delete;
  ReadingLimit& operator=(const ReadingLimit&) = delete;

 private:
  static void set(double seconds) {
    itimerval limit{};
    limit.it_value.tv_sec = static_cast<time_t>(seconds);
    setitimer(ITIMER_PROF, &limit, nullptr);  // SIGPROF, which ends a program that does not heed it
  }
};

/// gmsh throws for some unreadable files and gives nothing for others: both end here as no shapes.
gmsh::vectorpair shapes_in(const MesherSolid& solid) {
  if (is_iges(solid) && !begins_as_iges(solid.file)) return {};
  if (is_brep(solid))
    check_brep_text(solid, content_of(solid.file));
  else if (!is_iges(solid))
    check_step_text(solid, content_of(solid.file));
  constexpr double millimetre = 1e-3;
  gmsh::option::setString("Geometry.OCCTargetUnit", "M");  // of STEP; millimetres otherwise, as of IGES always
  gmsh::option::setNumber("Geometry.OCCScaling", is_iges(solid) ? millimetre * solid.scale : solid.scale);
  gmsh::vectorpair shapes;
  const ReadingLimit limit(solid.file);
  try {
    occ::importShapes(solid.file, shapes, true);
  } catch (const std::string&) {
    shapes.clear();
  }
  return shapes;
}

std::vector<int> volumes_among(const gmsh::vectorpair& shapes) {
  std::vector<int> volumes;
  for (const auto& [dimension, tag] : shapes)
    if (dimension == 3) volumes.push_back(tag);
  return volumes;
}

/// Loose faces as solids, where they meet within 10⁻⁵ of the whole.
std::vector<int> sewn(const gmsh::vectorpair& faces) {
  constexpr double reach = 1e-5;
  Eigen::AlignedBox3d bounds;
  for (const auto& [dimension, tag] : faces) {
    Vec3 low, high;
    occ::getBoundingBox(dimension, tag, low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
    bounds.extend(low).extend(high);
  }
  gmsh::vectorpair healed;
  try {
    occ::healShapes(healed, faces, reach * bounds.diagonal().norm(), true, true, true, true, true);
  } catch (const std::string&) {
    healed.clear();
  }
  return volumes_among(healed);
}

}  // namespace

bool is_iges(const MesherSolid& solid) {
  const std::string ending = ending_of(solid.file);
  return ending == ".iges" || ending == ".igs";
}

std::vector<int> read_cad(const MesherSolid& solid) {
  const gmsh::vectorpair shapes = shapes_in(solid);
  const std::string format = format_of(solid);
  if (shapes.empty())
    throw InputError(solid.file_as_written, "is not a readable " + format + " file",
                     "export the solid again as " + format);
  std::vector<int> volumes = volumes_among(shapes);
  if (volumes.empty()) volumes = sewn(shapes);
  if (volumes.empty())
    throw InputError(solid.file_as_written, "holds surfaces but no closed solid", "export a closed solid");
  if (!(volume_of(volumes) > 0))
    throw InputError(solid.file_as_written, "holds a solid without volume or inside out", "export a closed solid");
  check_edge_lengths(solid, volumes);
  occ::synchronize();
  check_edges_on_faces(solid, volumes);
  place_volumes(solid.placement, volumes);
  return volumes;
}

}  // namespace talus
