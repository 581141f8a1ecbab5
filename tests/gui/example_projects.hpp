#pragma once

#include <cmath>
#include <string>

/// Projects and files of geometry that the window is looked at with.
namespace talus::example {

/// A slab of rock in a quarry face, cut by its bedding and two upright sets, loaded, anchored and watched.
inline const char* const slope = R"({
  "talus": 1, "name": "Quarry, north face",
  "materials": {
    "limestone": {"density": 2650, "young": 30e9, "poisson": 0.25},
    "weathered limestone": {"density": 2450, "young": 4e9, "poisson": 0.28, "damping": 0.5}},
  "joints": {
    "bedding": {"friction_angle": 24, "residual_friction_angle": 14, "cohesion": 20e3},
    "J2 cross joints": {"friction_angle": 35},
    "J3": {"friction_angle": 32, "normal_stiffness": 2e9, "shear_stiffness": 1e9}},
  "default_joint": "bedding",
  "solids": [
    {"name": "ground", "material": "limestone", "body": "fixed", "mesh_size": 8,
     "section": {"points": [[0, 0], [36, 0], [36, 22], [12, 6], [0, 6]], "origin": [0, 8, 0], "azimuth": 90, "width": 16}},
    {"name": "slab", "material": "weathered limestone", "mesh_size": 4,
     "section": {"points": [[12, 6], [36, 22], [36, 25], [20, 24]], "origin": [0, 8, 0], "azimuth": 90, "width": 16}}],
  "cuts": [
    {"joint": "bedding", "dip": 33.7, "dip_direction": 270, "through": [18, 8, 14], "solids": ["slab"]},
    {"joint": "J2 cross joints", "dip": 75, "dip_direction": 90, "through": [20, 8, 16], "spacing": 6, "count": 2,
     "solids": ["slab"]},
    {"joint": "J3", "dip": 88, "dip_direction": 5, "through": [24, 8, 18], "solids": ["slab"]}],
  "blocks": [{"name": "crest", "at": [22, 3, 23.5], "mesh_size": 2.5}],
  "mesh": {"refinements": [{"at": [20, 8, 24], "radius": 4, "size": 2}]},
  "interfaces": [{"between": ["crest", "ground"], "joint": "J3"}],
  "loads": [
    {"block": "crest", "at": [22, 3, 24], "table": [[0, 0, 0, 0], [0.4, 0, 0, -400e3], [0.8, -250e3, 0, -400e3], [1, -250e3, 100e3, -150e3]]},
    {"block": "crest", "at": [21, 4, 23], "force": [180e3, 0, -60e3]}],
  "constraints": [{"block": "crest", "at": [23, 2, 23], "displacement": [0, null, null]}],
  "velocities": [{"block": "crest", "linear": [-0.1, 0, 0]}],
  "in_situ": [{"blocks": ["ground"], "stress": [-1e6, -1e6, -2e6, 0, 0, 0], "gradient": [9e3, 9e3, 26e3, 0, 0, 0], "level": 22}],
  "stages": [
    {"name": "settle", "type": "static", "time_step": 0.01, "steps": 20, "until_equilibrium": true},
    {"name": "soften and let go", "type": "dynamic", "time_step": 0.01, "duration": 1,
     "joints": {"bedding": {"friction_angle": 15, "cohesion": 0}}, "constraints": []}],
  "monitors": [{"name": "crest", "block": "crest", "at": [21, 2, 24]}, {"name": "heel", "block": "crest", "at": [23, 4, 24], "stress": true}],
  "expect": [{"quantity": "crest.displacement.z", "time": 0.5, "value": -0.1, "tolerance": 0.5, "source": "survey of May"}],
  "output": {"every": 0.05}
})";

/// Half of a box of 1000 × 3000 × 2000 units, longest along y.
inline const char* const tall_prism = R"(solid prism
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 3000 0 vertex 1000 0 0 endloop endfacet
facet normal 0 0 0 outer loop vertex 0 0 2000 vertex 1000 0 2000 vertex 0 3000 2000 endloop endfacet
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 1000 0 0 vertex 1000 0 2000 endloop endfacet
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 1000 0 2000 vertex 0 0 2000 endloop endfacet
facet normal 0 0 0 outer loop vertex 1000 0 0 vertex 0 3000 0 vertex 0 3000 2000 endloop endfacet
facet normal 0 0 0 outer loop vertex 1000 0 0 vertex 0 3000 2000 vertex 1000 0 2000 endloop endfacet
facet normal 0 0 0 outer loop vertex 0 3000 0 vertex 0 0 0 vertex 0 0 2000 endloop endfacet
facet normal 0 0 0 outer loop vertex 0 3000 0 vertex 0 0 2000 vertex 0 3000 2000 endloop endfacet
endsolid prism
)";

/// The same with a hole: its last triangle is missing.
inline std::string open_prism() {
  std::string prism = tall_prism;
  const std::size_t last = prism.rfind("facet normal");
  return prism.erase(last, prism.rfind("endsolid") - last);
}

/// Heights of a hillside in the coordinates of a national grid.
inline std::string hillside() {
  std::string grid = "ncols 24\nnrows 18\nxllcorner 2600000\nyllcorner 1200000\ncellsize 10\nNODATA_value -9999\n";
  for (int row = 0; row < 18; ++row) {
    for (int column = 0; column < 24; ++column)
      grid += std::to_string(500 + 4 * column + 12 * std::sin(0.5 * row) * std::cos(0.4 * column)) + ' ';
    grid += '\n';
  }
  return grid;
}

/// A cube whose upper edges are taken off by 0.1 mm.
inline const char* const splinters = R"({
  "talus": 1, "name": "Thin edges", "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
  "joints": {"east": {"friction_angle": 30}, "west": {"friction_angle": 30}}, "default_joint": "east",
  "solids": [{"name": "cube", "material": "rock", "body": "rigid", "mesh_size": 5,
              "box": {"min": [0, 0, 0], "max": [10, 10, 10]}}],
  "cuts": [{"joint": "east", "dip": 45, "dip_direction": 90, "through": [10, 5, 9.9999]},
           {"joint": "west", "dip": 45, "dip_direction": 270, "through": [0, 5, 9.9999]}],
  "splinters": {"rule": "refuse"},
  "stages": [{"name": "go", "type": "dynamic", "time_step": 0.01, "steps": 1}]
})";

/// A cube that drops on a base, with too few iterations for the blow.
inline const char* const dropped = R"({
  "talus": 1, "name": "Dropped cube",
  "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
  "joints": {"J1": {"friction_angle": 30}}, "default_joint": "J1",
  "solids": [
    {"name": "base", "box": {"min": [0, 0, 0], "max": [8, 6, 1]}, "material": "rock", "body": "fixed", "mesh_size": 2},
    {"name": "cube", "box": {"min": [2, 2, 1.05], "max": [4, 4, 3.05]}, "material": "rock", "mesh_size": 1}],
  "solver": {"open_close_limit": 2},
  "stages": [{"name": "drop", "type": "dynamic", "time_step": 0.002, "steps": 150}], "output": {"every": 0.02}
})";

/// Three sets that scatter, 120 planes in all.
inline const char* const survey = R"({
  "talus": 1, "name": "Survey of May",
  "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.24}},
  "joints": {"bedding": {"friction_angle": 28}, "J1": {"friction_angle": 35}, "J2": {"friction_angle": 35}},
  "default_joint": "J1",
  "solids": [{"name": "rock", "material": "rock", "body": "rigid", "box": {"min": [0, 0, 0], "max": [90, 90, 60]}}],
  "cuts": [
    {"joint": "bedding", "dip": 42, "dip_direction": 140, "through": [45, 45, 0], "spacing": 2, "count": 50,
     "fisher_kappa": 90},
    {"joint": "J1", "dip": 86, "dip_direction": 50, "through": [10, 10, 30], "spacing": 3, "count": 40,
     "fisher_kappa": 60, "seed": 2},
    {"joint": "J2", "dip": 74, "dip_direction": 318, "through": [80, 10, 30], "spacing": 3, "count": 30,
     "fisher_kappa": 120, "seed": 3},
    {"joint": "J2", "dip": 70, "dip_direction": 200, "seed": 3,
     "network": {"box": {"min": [20, 20, 20], "max": [60, 60, 50]}, "density": 0.02, "radius": 8}}],
  "stages": [{"name": "go", "type": "dynamic", "time_step": 0.01, "steps": 1}]
})";

}  // namespace talus::example
