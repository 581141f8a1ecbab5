#pragma once

#include "widgets/forms/field.hpp"

class QVBoxLayout;

namespace talus {

/// All fields that a thing may have, in the order of the schema. Those that the file leaves out say what that means,
/// and can be set; those that are set and need not be can be left out again.
class ObjectField : public FormField {
  Q_OBJECT
 public:
  /// Which fields are shown.
  enum class Depth { all, inFile, none };
  /// `withoutThings`: without lists and objects, which have forms of their own.
  ObjectField(const FieldSite& site, QWidget* parent, bool withoutThings = false);

 private:
  void addMembers(Depth depth, bool withoutThings);
  bool isShown(const std::string& key, const FieldSite& field, bool withoutThings) const;
  void addRow(const FieldSite& field);
  void addVariantRow();
  Depth addPresets();
  QWidget* makeUnset(const FieldSite& field);
  QWidget* makeClear(const FieldSite& field);
};

}  // namespace talus
