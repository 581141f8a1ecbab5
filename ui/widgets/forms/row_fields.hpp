#pragma once

#include "widgets/forms/field.hpp"

namespace talus {

struct PickedPlace;

/// So many numbers in a row: a vector, a stress. Typing one where the file leaves all out sets them. A place can be
/// picked in the view too; the block of a thing that acts on one then is the one that was picked.
class VectorField : public FormField {
  Q_OBJECT
 public:
  VectorField(const FieldSite& site, QWidget* parent);

 private:
  QWidget* makePickButton();
  void askForPlace(Picking& picking);
  void takePlace(const PickedPlace& picked);
};

/// So many names in a row: a pair of blocks.
class NamesField : public FormField {
  Q_OBJECT
 public:
  NamesField(const FieldSite& site, QWidget* parent);
};

}  // namespace talus
