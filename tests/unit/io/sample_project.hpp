#pragma once

#include <string>

namespace talus::test {

/// A project with every key of the format, odd numbers, and comments in every kind of place.
inline const std::string full_project = R"(// A slope above a road.
{
  "talus": 1, // the format
  "name": "Full \"slope\" – Südhang",
  "gravity": [0, -0.0, -9.80665],

  /* Rock from the
     laboratory */
  "materials": {
    "soft rock": {"density": 2.1e3, "young": 1e9, "poisson": 0.3}, // first, though later in the alphabet
    "hard/rock": {"density": 2600, "young": 25E+9, "poisson": -0.1}
  },
  "joints": {
    // bedding
    "J2": {"friction_angle": 8},
    "J1": {
      "friction_angle": 30, "cohesion": 2e5, "tensile_strength": 1e4, // broken by the driving block
      "residual_friction_angle": 25, "normal_stiffness": 1e10, "shear_stiffness": 4e9
    }
  },
  "default_joint": "J1",
  "solids": [
    {"name": "slope", "box": {"min": [0, 0, 0], "max": [10, 10, 10]}, "material": "soft rock", "mesh_size": 0.3333333333333333},
    // the wedge that falls
    {"name": "wedge", "material": "hard/rock", "body": "tetrahedra",
     "polyhedron": {
       "vertices": [[20, 0, 0], [21, 0, 0], [20, 1, 0], [20, 0, 1.0000000000000002]],
       "faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]] /* outwards */
     }},
    {"name": "hill", "file": "shapes/hill.step", "scale": 0.001, "material": "soft rock", "body": "fixed"}
  ],
  "cuts": [
    {"joint": "J1", "dip": 35, "dip_direction": 120, "through": [5, 5, 5], "solids": ["slope", "hill"]},
    {"joint": "J2", "dip": 90, "dip_direction": 360, "through": [1e-3, 5, 5], "spacing": 2.0, "count": 3} // last
    // nothing else
  ],
  "blocks": [
    {"name": "top", "at": [5, 5, 9], "body": "tetrahedra", "material": "hard/rock", "mesh_size": 0.5},
    {"name": "foot", "at": [5, 5, 1], "body": "fixed"}
  ],
  "interfaces": [{"between": ["top", "wedge"], "joint": "J2"}],
  "constraints": [
    {"block": "foot", "at": [0, 0, 0], "displacement": [0, null, -0.001]}
  ],
  "loads": [{"block": "top", "at": [5, 5, 10], "force": [0, 0, -1e6]}],
  "velocities": [{"block": "wedge", "linear": [1, 0, 0], "angular": [0, 0, 0.1]}, {"block": "top"}],
  "stages": [
    {"name": "gravity", "type": "static", "time_step": 0.01, "steps": 4000},
    {"name": "slide", "type": "dynamic", "time_step": 0.005, "duration": 60}
  ],
  "solver": {"strain": "incremental", "integrator": "constant-acceleration", "contact_stiffness": 12.5, "open_close_limit": 8},
  "monitors": [{"name": "P1", "block": "top", "at": [5, 5, 10]}],
  "expect": [
    {"quantity": "P1.displacement.z", "time": 41, "since": 40, "value": -4.905, "tolerance": 1e-6, "source": "½gt²"},
    {"quantity": "slope.2.velocity.magnitude", "time": 100, "value": 0, "tolerance": 1e-9}
  ],
  "output": {"every": 0.25}
}
// the end
)";

/// The least that is a project.
inline const std::string small_project = R"({
  "talus": 1,
  "materials": {
    "rock": {"density": 2600, "young": 25e9, "poisson": 0.24}
  },
  "joints": {
    "J1": {"friction_angle": 30},
    "J2": {"friction_angle": 8}
  },
  "default_joint": "J1",
  "solids": [
    {"name": "slope", "box": {"min": [0, 0, 0], "max": [10, 10, 10]}, "material": "rock"}
  ],
  "cuts": [
    {"joint": "J2", "dip": 35, "dip_direction": 120, "through": [5, 5, 5]}
  ],
  "stages": [
    {"name": "slide", "type": "dynamic", "time_step": 0.01, "steps": 100}
  ]
}
)";

/// `text` with the first `what` replaced; throws when it is not there, so that a test cannot pass for want of a change.
inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

}  // namespace talus::test
