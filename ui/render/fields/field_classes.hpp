#pragma once

#include <string>
#include <vector>

#include "render/paint/colour.hpp"
#include "results/field.hpp"

namespace talus {

/// What one of a field's classes is drawn and called.
struct FieldClass {
  Rgb colour;
  std::string word;
};

/// Of a field that `is_class()`, by its values from 0.
std::vector<FieldClass> classes_of(const Field& field);

/// Of contact points: open grey, stick blue, slip orange.
Rgb state_colour(ContactState state);

}  // namespace talus
