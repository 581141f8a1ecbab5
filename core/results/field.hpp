#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "results/frame.hpp"

namespace talus {

/// What a field has a value of each. A wall is a point of the surface (fields/joint_walls).
enum class FieldPlace { node, tetrahedron, block, wall };

/// A scalar that a frame can be coloured, plotted or exported by.
struct Field {
  enum class Source { displacement, velocity, rotation, stress, strain, block, joint };
  enum class Measure {
    magnitude,      ///< length of the vector; of stress: von Mises; of rotation: its angle
    component,      ///< `index` of x, y, z or of xx, yy, zz, xy, yz, zx
    mean,           ///< of stress and strain from here on
    max_principal,  ///< largest tension
    min_principal,  ///< largest compression
    max_shear,
    safety,      ///< of stress: over Mohr and Coulomb's strength of the rock (fields/rock_safety)
    volumetric,  ///< of strain
    body,        ///< of blocks, a class: BodyKind
    motion,      ///< likewise: MotionMode
    sleep,       ///< likewise: SleepState of fields/field_values
    normal,      ///< of joints from here on: stress, compression positive
    shear,       ///< stress
    mobilised,   ///< shear stress over shear strength
    cohesion,    ///< of bonds that are whole
    slip,        ///< how far places that touched at the start have gone along each other
    opening,     ///< … and apart
    state,       ///< a class: WallState of fields/field_values
    bond         ///< a class: Bond
  };

  std::string_view name;   ///< as in `--field`, for example "stress.von_mises"
  std::string_view title;  ///< for a legend, for example "von Mises stress"
  std::string_view unit;   ///< SI, "m", "m/s", "Pa" or "°"; empty: a ratio, or a class
  Source source;
  Measure measure;
  int index = 0;

  FieldPlace place() const {
    switch (source) {
      case Source::displacement:
      case Source::velocity:
        return FieldPlace::node;
      case Source::stress:
      case Source::strain:
        return FieldPlace::tetrahedron;
      case Source::rotation:
      case Source::block:
        return FieldPlace::block;
      case Source::joint:
        break;
    }
    return FieldPlace::wall;
  }
  /// Its values number classes, which have words and no order.
  bool is_class() const {
    return measure == Measure::state || measure == Measure::bond || measure == Measure::body ||
           measure == Measure::motion || measure == Measure::sleep;
  }
  bool operator==(const Field& other) const { return name == other.name; }
};

/// Every field, in the order in which a menu shows them.
std::span<const Field> all_fields();

/// The field of that name; "displacement" and "velocity" are magnitudes, "stress" is von Mises.
/// Throws InputError that lists the names.
const Field& field_named(std::string_view name);

/// The field in its SI unit, one value a node or a tetrahedron as `field.place()` says: displacement, velocity and
/// stress but for its safety. Those that need to know the blocks as well are told by FieldValues (fields/field_values);
/// here they are std::invalid_argument.
std::vector<double> values(const Frame& frame, const Field& field);

/// √(3 J₂) of a stress [Pa].
double von_mises(const Voigt& stress);

/// Principal stresses [Pa], descending: tension first.
Vec3 principal_stresses(const Voigt& stress);

/// The same with their directions, unit, in columns.
struct PrincipalAxes {
  Vec3 values = Vec3::Zero();
  Mat3 directions = Mat3::Identity();
};
PrincipalAxes principal_axes(const Voigt& stress);

}  // namespace talus
