#pragma once

#include <string>

namespace talus::test {

/// A project with every key of the format, odd numbers, and comments in every kind of place.
inline const std::string full_project = R"(// A slope above a road.
{
  "talus": 1, // the format
  "name": "Full \"slope\" – Südhang",
  "gravity": [0, -0.0, -9.80665],
  "origin": [2600000, 1200000.5, 400], // of the survey

  /* Rock from the
     laboratory */
  "materials": {
    "soft rock": {"density": 2.1e3, "young": 1e9, "poisson": 0.3, "law": "neo-hookean", "strength": {"cohesion": 2e6, "friction_angle": 35, "tensile_strength": 5e5}}, // first, though later in the alphabet
    "hard/rock": {"density": 2600, "young": 25E+9, "poisson": -0.1, "damping": 0.5}
  },
  "joints": {
    // bedding
    "J2": {"friction_angle": 8},
    "J1": {
      "friction_angle": 30, "cohesion": 2e5, "tensile_strength": 1e4, // broken by the driving block
      "residual_friction_angle": 25, "normal_stiffness": 1e10, "shear_stiffness": 4e9, "restitution": 0.4
    }
  },
  "default_joint": "J1",
  "solids": [
    {"name": "slope", "box": {"min": [0, 0, 0], "max": [10, 10, 10]}, "material": "soft rock", "mesh_size": 0.3333333333333333},
    // the wedge that falls
    {"name": "wedge", "material": "hard/rock", "body": "auto",
     "polyhedron": {
       "vertices": [[20, 0, 0], [21, 0, 0], [20, 1, 0], [20, 0, 1.0000000000000002]],
       "faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]] /* outwards */
     }},
    {"name": "hill", "file": "shapes/hill.step", "scale": 0.001, "material": "soft rock", "body": "fixed",
     "turn": {"axis": [0, 0, 1], "angle": 30, "about": [1, 2, 3]}, "move": [0, 0, -0.5]},
    {"name": "land", "terrain": {"file": "land.asc", "base": 100, "tolerance": 0.25}, "material": "hard/rock"},
    {"name": "bore", "cylinder": {"from": [30, 0, 2], "to": [30, 10, 2], "radius": 1.5, "sides": 12}, "material": "soft rock"},
    {"name": "bench", "section": {"points": [[0, 0], [20, 0], [20, 10], [10, 10]], "origin": [40, 0, 0], "azimuth": 75, "width": 8}, "material": "soft rock"},
    // a tunnel through the bench
    {"name": "driven", "combine": {"operation": "subtract", "solids": ["bench", "bore"]}, "material": "soft rock"}
  ],
  "cuts": [
    {"joint": "J1", "dip": 35, "dip_direction": 120, "through": [5, 5, 5], "solids": ["slope", "hill"]},
    {"joint": "J2", "dip": 60, "dip_direction": 30, "through": [5, 5, 5], "spacing": 1.5, "count": 4,
     "spacing_law": "lognormal", "spacing_deviation": 0.25, "fisher_kappa": 120, "seed": 7},
    {"joint": "J2", "dip": 90, "dip_direction": 360, "through": [1e-3, 5, 5], "spacing": 2.0, "count": 3},
    {"joint": "J2", "dip": 10, "dip_direction": 45, "disc": {"centre": [4, 4, 4], "radius": 2.5}, "ends_at": ["J1"]},
    {"joint": "J2", "dip": 0, "dip_direction": 0, "polygon": [[0, 0, 2], [4, 0, 2], [4, 4, 2]]},
    {"joint": "J1", "dip": 70, "dip_direction": 200, "fisher_kappa": 50, "seed": 3,
     "network": {"box": {"min": [0, 0, 0], "max": [10, 10, 10]}, "density": 0.5, "radius": 2,
                 "radius_law": "lognormal", "radius_deviation": 0.75}} // last
    // nothing else
  ],
  "blocks": [
    {"name": "top", "at": [5, 5, 9], "body": "tetrahedra", "material": "hard/rock", "mesh_size": 0.5},
    {"name": "foot", "at": [5, 5, 1], "body": "fixed"},
    {"name": "dug out", "at": [9, 9, 9], "removed": true}
  ],
  "merges": [{"at": [1, 1, 1], "with": [2, 1, 1]}],
  "splinters": {"thickness": 0.01, "rule": "merge", "chip_volume": 1e-05},
  "mesh": {"size": 1.25, "most_tetrahedra": 200000,
           "refinements": [{"at": [5, 5, 10], "radius": 2, "size": 0.2},
                           {"face": [[0, 0, 10], [4, 0, 10], [4, 4, 10]], "radius": 1, "size": 0.25}]},
  "interfaces": [{"between": ["top", "wedge"], "joint": "J2"}],
  "constraints": [
    {"block": "foot", "at": [0, 0, 0], "displacement": [0, null, -0.001]},
    {"block": "foot", "table": [[0, 0, 0, 0], [0.5, 0.02, 0, 0], // the base shakes
                                [1, -0.02, 0, 1e-3]]},
    {"block": "top", "at": [5, 5, 10], "table": [[0, 0, null, 0], [2.5, 0.001, null, -0.5]]}
  ],
  "loads": [
    {"block": "top", "at": [5, 5, 10], "force": [0, 0, -1e6]},
    {"block": "top", "at": [5, 0, 10], "table": [[0, 0, 0, 0], [1, 0, 0.25, -2e6]]}
  ],
  "velocities": [{"block": "wedge", "linear": [1, 0, 0], "angular": [0, 0, 0.1]}, {"block": "top"}],
  "in_situ": [
    {"stress": [-1e6, -2e6, -3e6, 1, 2, 3], "gradient": [1e4, 2e4, 26e3, 0, 0, 0.5], "level": 10}, // under the road
    {"blocks": ["top", "slope.2"], "stress": [0, 0, 0, 0, 0, 4e5]}
  ],
  "stages": [
    {"name": "gravity", "type": "static", "time_step": 0.01, "steps": 4000,
     "until_equilibrium": true, "equilibrium_tolerance": 0.001, "damping": 0.2,
     "blocks": [{"name": "top", "body": "fixed"}]}, // held until it is let go
    {"name": "slide", "type": "dynamic", "time_step": 0.005, "duration": 60,
     "joints": {
       "J2": {"friction_angle": 6}, // wet
       "J1": {"friction_angle": 20, "residual_friction_angle": 15, "cohesion": 0, "tensile_strength": 5e3}
     },
     "loads": [], // nothing presses any more
     "constraints": [{"block": "top", "at": [5, 5, 10], "displacement": [null, 0, null]}],
     "blocks": [{"name": "top", "body": "tetrahedra"}]}
  ],
  "solver": {
    "strain": "corotational", // said before the preset: the paper's is none for soft rock
    "preset": "paper", "open_close": "newton", "static_inertia": "fading", "extras": "called_for",
    "integrator": "generalized-alpha", "spectral_radius": 0.6,
    "contact": "area", "contact_stiffness": 12.5, "penetration_tolerance": 1e-6, "tolerance": "standard", "open_close_limit": 8, "sleep_tolerance": 1e-7,
    "effects": {"contact": "on", "rebound": "off", "restitution": "off", "missed_contacts": "on", "updated_normals": "off",
                "penalty_scaling": "on", "followed_springs": "off", "acceleration_reset": "on", "sleep": "on",
                "elimination": "off"},
    "time_step_control": "adaptive",
    "adaptive": {"displacement_limit": 0.01, "error_limit": 1e-5, "iterations": 6, "shortest": 0.01} // of time_step
  },
  "monitors": [{"name": "P1", "block": "top", "at": [5, 5, 10]}, {"name": "P2", "block": "top", "at": [5, 5, 9], "stress": true}],
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
