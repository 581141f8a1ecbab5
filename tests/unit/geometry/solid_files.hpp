#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <string>
#include <vector>

#include "base/temporary_folder.hpp"
#include "geometry/solid_surface.hpp"
#include "rock.hpp"

/// Files that solids are read from, written by the tests themselves.
namespace talus::rock {

/// A surface as a test has it: points, and triangles that look outwards.
struct Surface {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

inline Surface cube_surface(const Vec3& low = {0, 0, 0}, const Vec3& high = {10, 10, 10}) {
  Surface cube;
  for (int i = 0; i < 8; ++i)
    cube.points.emplace_back((i & 1 ? high : low).x(), (i & 2 ? high : low).y(), (i & 4 ? high : low).z());
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return cube;
}

/// Both, without joining them.
inline Surface together(Surface a, const Surface& b) {
  const int first = static_cast<int>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& [i, k, l] : b.triangles) a.triangles.push_back({first + i, first + k, first + l});
  return a;
}

inline Surface turned(Surface surface) {
  for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
  return surface;
}

/// A sphere of four triangles to each face of an octahedron, again and again.
inline Surface sphere(double radius, int divisions) {
  Surface ball;
  ball.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  ball.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int k = 0; k < divisions; ++k) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [known, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(ball.points.size()));
      if (fresh) ball.points.push_back((ball.points[a] + ball.points[b]).normalized());
      return known->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : ball.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const auto& t : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) finer.push_back(t);
    }
    ball.triangles = finer;
  }
  for (Vec3& point : ball.points) point *= radius;
  return ball;
}

/// m³, by the divergence theorem about the first point.
inline double volume_of(const Surface& surface) {
  double sum = 0;
  const Vec3 origin = surface.points.front();
  for (const auto& [a, b, c] : surface.triangles)
    sum += (surface.points[a] - origin).dot((surface.points[b] - origin).cross(surface.points[c] - origin)) / 6;
  return sum;
}

/// A folder for one test, with what writes files there and reads solids from them.
class SolidFiles : public testing::Test {
 protected:
  std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(at(name), std::ios::binary) << text;
  }

  void write_stl(const std::string& name, const Surface& surface) const {
    std::ofstream file(at(name));
    file << std::setprecision(17) << "solid talus\n";
    for (const auto& triangle : surface.triangles) {
      file << "facet normal 0 0 0\nouter loop\n";
      for (const int v : triangle) file << "vertex " << surface.points[v].transpose() << "\n";
      file << "endloop\nendfacet\n";
    }
    file << "endsolid talus\n";
  }

  void write_binary_stl(const std::string& name, const Surface& surface) const {
    std::ofstream file(at(name), std::ios::binary);
    const auto put = [&](const auto& value) { file.write(reinterpret_cast<const char*>(&value), sizeof value); };
    file << std::string(80, ' ');
    put(static_cast<std::uint32_t>(surface.triangles.size()));
    for (const auto& triangle : surface.triangles) {
      for (int k = 0; k < 3; ++k) put(0.0F);
      for (const int v : triangle)
        for (int k = 0; k < 3; ++k) put(static_cast<float>(surface.points[v][k]));
      put(std::uint16_t{0});
    }
  }

  void write_obj(const std::string& name, const Surface& surface) const {
    std::ofstream file(at(name));
    file << std::setprecision(17);
    for (const Vec3& point : surface.points) file << "v " << point.transpose() << "\n";
    for (const auto& [a, b, c] : surface.triangles) file << "f " << a + 1 << " " << b + 1 << " " << c + 1 << "\n";
  }

  SolidSurface surface_of(const Solid& solid, const Vec3& origin = Vec3::Zero()) const {
    NoProgress nobody;
    return solid_surface(solid, origin, folder_.path(), nobody);
  }
  SolidSurface surface_in(const std::string& name, double scale = 1) const {
    return surface_of(solid("rock", FileShape{name, scale}));
  }

  /// The message of the InputError when the file is looked at.
  std::string error_in(const std::string& name) const {
    try {
      surface_in(name);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  Project project_of(const std::vector<Solid>& solids) const {
    Project p = project();
    p.solids = solids;
    return p;
  }

  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

/// How many of a kind were found; negative when they were not mended.
inline int found(const SolidSurface& surface, SurfaceFinding::Kind kind) {
  int count = 0;
  for (const SurfaceFinding& finding : surface.findings)
    if (finding.kind == kind) count += finding.mended ? finding.count : -finding.count;
  return count;
}

}  // namespace talus::rock
