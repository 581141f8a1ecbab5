#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "results/frame.hpp"

namespace talus {

enum class FieldPlace { node, tetrahedron };

/// A scalar that a frame can be coloured, plotted or exported by.
struct Field {
  enum class Source { displacement, velocity, stress };
  enum class Measure {
    magnitude,      ///< length of the vector; of stress: von Mises
    component,      ///< `index` of x, y, z or of xx, yy, zz, xy, yz, zx
    mean,           ///< of stress from here on
    max_principal,  ///< largest tension
    min_principal,  ///< largest compression
    max_shear
  };

  std::string_view name;   ///< as in `--field`, for example "stress.von_mises"
  std::string_view title;  ///< for a legend, for example "von Mises stress"
  std::string_view unit;   ///< SI, "m", "m/s" or "Pa"
  Source source;
  Measure measure;
  int index = 0;

  FieldPlace place() const { return source == Source::stress ? FieldPlace::tetrahedron : FieldPlace::node; }
  bool operator==(const Field& other) const { return name == other.name; }
};

/// Every field, in the order in which a menu shows them.
std::span<const Field> all_fields();

/// The field of that name; "displacement" and "velocity" are magnitudes, "stress" is von Mises.
/// Throws InputError that lists the names.
const Field& field_named(std::string_view name);

/// The field in its SI unit, one value a node or a tetrahedron as `field.place()` says.
std::vector<double> values(const Frame& frame, const Field& field);

/// √(3 J₂) of a stress [Pa].
double von_mises(const Voigt& stress);

/// Principal stresses [Pa], descending: tension first.
Vec3 principal_stresses(const Voigt& stress);

}  // namespace talus
