#pragma once

#include "widgets/forms/field.hpp"

namespace talus {

/// Any number of things, each with its own editor: a list, or things by name. They are added and taken away here.
class ListField : public FormField {
  Q_OBJECT
 public:
  ListField(const FieldSite& site, QWidget* parent);

 private:
  QWidget* makeEntry(const FieldSite& entry);
};

}  // namespace talus
