#pragma once

#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "results/frame.hpp"
#include "results/result_folder.hpp"

namespace talus {

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A new empty folder that goes with all it holds.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "talus-results-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make " + pattern);
    path = pattern;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path path;
};

/// A deterministic number in −1 … 1 that needs all its digits.
inline double number(int i, int j, int k = 0) { return std::sin(1.0 + 12.9898 * i + 78.233 * j + 37.719 * k); }

/// A block of `cells` tetrahedra in a row, each with nodes of its own.
inline Block example_block(const std::string& name, int cells, double shift) {
  Block block{.name = name,
              .solid = 1,
              .material = 0,
              .body = BodyKind::tetrahedra,
              .mesh = {},
              .surface = {},
              .volume = cells / 6.0};
  for (int i = 0; i < cells; ++i) {
    const Vec3 origin(shift + i + 1e-9 * number(i, 3), 0.1, 400000.3);
    for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
      block.mesh.nodes.push_back(origin + corner);
    const int n = 4 * i;
    block.mesh.tetrahedra.push_back({n, n + 1, n + 2, n + 3});
    for (const std::array<int, 3>& face : {std::array{n, n + 2, n + 1}, std::array{n, n + 1, n + 3},
                                           std::array{n, n + 3, n + 2}, std::array{n + 1, n + 2, n + 3}})
      block.surface.push_back({face, i % 3 - 1});
  }
  return block;
}

inline BlockSystem example_system(int cells_a = 2, int cells_b = 3) {
  BlockSystem system{.blocks = {example_block("B1", cells_a, 0), example_block("Fels ä, \"2\"", cells_b, 50)},
                     .joint_names = {"J1", "J2"},
                     .solids_volume = 5.25};
  system.blocks[0].body = BodyKind::fixed;
  system.blocks[1].material = 1;
  system.strengths = {std::nullopt, RockStrength{.cohesion = 2e4, .friction_angle = 25}};
  return system;
}

inline Project example_project() {
  Project project;
  project.name = "Two <blocks> & a slide";
  project.materials = {{"rock", 2600, 25e9, 0.24}, {"clay", 1900, 1e8, 0.3}};
  project.materials[1].strength = RockStrength{.cohesion = 2e4, .friction_angle = 25};
  project.stages.resize(2);
  project.stages[0].name = "gravity";
  project.stages[1].name = "slide";
  project.monitors.resize(2);
  project.monitors[0].name = "P1";
  project.monitors[1].name = "P, 2";
  return project;
}

/// Frame `index` of a run on the system; every number depends on it. Every third frame has no contacts.
inline Frame example_frame(const BlockSystem& system, int index) {
  Frame frame;
  frame.index = index;
  frame.time = 0.1 * index;
  frame.stage = index % 2;
  int n = 0;
  for (const Block& block : system.blocks) {
    for (std::size_t i = 0; i < block.mesh.nodes.size(); ++i, ++n) {
      frame.displacement.emplace_back(number(index, n, 1), number(index, n, 2), number(index, n, 3));
      frame.velocity.emplace_back(number(index, n, 4), number(index, n, 5), number(index, n, 6));
    }
    for (std::size_t i = 0; i < block.mesh.tetrahedra.size(); ++i) {
      Voigt stress;
      for (int k = 0; k < 6; ++k) stress[k] = static_cast<float>(1e6 * number(index, static_cast<int>(i) + n, k));
      frame.stress.push_back(stress);
    }
  }
  for (int i = 0; i < index % 3; ++i)
    frame.contacts.push_back({.position = Vec3(number(index, i), 2, 3),
                              .normal = Vec3(0, number(index, i, 1), 1),
                              .blocks = {0, 1},
                              .joint = i - 1,
                              .state = static_cast<ContactState>(i),
                              .normal_force = 1e7 * number(index, i, 2),
                              .shear_force = Vec3(1, number(index, i, 3), 0),
                              .area = number(index, i, 4),
                              .friction = number(index, i, 5),
                              .cohesion = 1e5 * number(index, i, 6),
                              .bond = static_cast<Bond>((index + i) % 3)});
  if (index % 2 == 1)
    for (std::size_t b = 0; b < system.blocks.size(); ++b)
      frame.motions.push_back({.mode = static_cast<MotionMode>((static_cast<std::size_t>(index) + b) % 9),
                               .came_to_rest = b == 1,
                               .joints = {index, -1},
                               .against = {0, static_cast<int>(b)},
                               .direction = Vec3(number(index, 7), 1, 2),
                               .line = Vec3(3, number(index, 8), 4),
                               .axis = Vec3(5, 6, number(index, 9)),
                               .rotation_share = number(index, 10)});
  if (index % 4 != 2) frame.asleep = {0, static_cast<char>(index % 4 == 1)};
  return frame;
}

inline bool same(const ContactSample& a, const ContactSample& b) {
  return a.position == b.position && a.normal == b.normal && a.blocks[0] == b.blocks[0] && a.blocks[1] == b.blocks[1] &&
         a.joint == b.joint && a.state == b.state && a.normal_force == b.normal_force &&
         a.shear_force == b.shear_force && a.area == b.area && a.friction == b.friction && a.cohesion == b.cohesion &&
         a.bond == b.bond;
}

/// Bit for bit, stresses too where they were floats to begin with.
inline bool same(const Frame& a, const Frame& b) {
  return a.index == b.index && a.time == b.time && a.stage == b.stage && a.displacement == b.displacement &&
         a.velocity == b.velocity && a.stress == b.stress && a.motions == b.motions && a.asleep == b.asleep &&
         std::equal(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end(),
                    [](const ContactSample& x, const ContactSample& y) { return same(x, y); });
}

}  // namespace talus
