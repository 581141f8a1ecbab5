#pragma once

#include "widgets/forms/field.hpp"

namespace talus {

/// So many numbers in a row: a vector, a stress. Typing one where the file leaves all out sets them.
class VectorField : public FormField {
  Q_OBJECT
 public:
  explicit VectorField(const FieldSite& site);
};

/// So many names in a row: a pair of blocks.
class NamesField : public FormField {
  Q_OBJECT
 public:
  explicit NamesField(const FieldSite& site);
};

}  // namespace talus
