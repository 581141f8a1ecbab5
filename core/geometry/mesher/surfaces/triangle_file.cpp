#include "geometry/mesher/surfaces/triangle_file.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.hpp"

namespace talus {
namespace {

using FilePoint = CGAL::Simple_cartesian<double>::Point_3;
using FilePolygon = std::vector<std::size_t>;

/// CGAL 5.5 takes a property of a PLY file for one of the element before it, whether there is one or not.
bool properties_follow_elements(std::istream& file) {
  bool holds = true, element = false;
  std::string word;
  for (std::string line; word != "end_header" && std::getline(file, line);) {
    std::istringstream(line) >> word;
    element = element || word == "element";
    holds = holds && (element || word != "property");
  }
  file.clear();
  file.seekg(0);
  return holds;
}

bool read(std::istream& file, const std::string& ending, std::vector<FilePoint>& points,
          std::vector<FilePolygon>& polygons) {
  if (ending == ".stl") return CGAL::IO::read_STL(file, points, polygons);
  if (ending == ".ply") return properties_follow_elements(file) && CGAL::IO::read_PLY(file, points, polygons);
  return CGAL::IO::read_OBJ(file, points, polygons);
}

std::string format_of(std::string ending) {
  ending.erase(0, 1);
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::toupper(c); });
  return ending;
}

}  // namespace

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

PolygonSoup read_polygons(const std::string& path, const std::string& as_written) {
  const std::string ending = ending_of(path), format = format_of(ending);
  std::ifstream file(path, std::ios::binary);
  std::vector<FilePoint> points;
  std::vector<FilePolygon> polygons;
  bool complete = false;
  try {
    complete = read(file, ending, points, polygons);
  } catch (const std::exception&) {
    // The readers throw for some files and say false for others.
  }
  if (polygons.empty())
    throw InputError(as_written, "is not a readable " + format + " file: it holds no faces",
                     "export the surface again as " + format);
  if (!complete)
    throw InputError(as_written, "is damaged after " + std::to_string(polygons.size()) + " faces",
                     "export the surface again as " + format);
  PolygonSoup soup;
  for (const FilePoint& point : points) {
    soup.points.emplace_back(point.x(), point.y(), point.z());
    if (!soup.points.back().allFinite())
      throw InputError(as_written,
                       "vertex " + std::to_string(soup.points.size()) + " has a coordinate that is no number",
                       "export the surface again as " + format);
  }
  for (const FilePolygon& polygon : polygons) {
    for (const std::size_t v : polygon)
      if (v >= points.size())
        throw InputError(as_written,
                         "face " + std::to_string(soup.polygons.size() + 1) + " has a vertex that is not there",
                         "export the surface again as " + format);
    if (polygon.size() >= 3) soup.polygons.emplace_back(polygon.begin(), polygon.end());
  }
  return soup;
}

}  // namespace talus
