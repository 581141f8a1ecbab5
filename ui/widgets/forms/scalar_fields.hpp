#pragma once

#include <functional>

#include "widgets/forms/field.hpp"

class QComboBox;

namespace talus {

class NumberField;

/// An entry for a number of a rule, in the units that the user chose; `none` is what it means to leave it empty.
NumberField* makeNumber(const schema::Json& rule, const schema::Json* value, const QString& none,
                        const QString& unit = {}, bool unitBehind = true);
/// A number as JSON has it: whole ones without a point, a count however large it is.
schema::Json jsonOf(double number, bool isCount = false);

/// One number. Left empty, the file leaves it out, or has null where the rule allows that.
class NumberEntry : public FormField {
  Q_OBJECT
 public:
  NumberEntry(const FieldSite& site, QWidget* parent);
};

/// A number that may be typed, or chosen by its name.
class NamedNumberField : public FormField {
  Q_OBJECT
 public:
  NamedNumberField(const FieldSite& site, QWidget* parent);

 private:
  void commit(const QString& typed);
};

/// One of some words, or yes and no; the first entry leaves it out where that is possible.
class ChoiceField : public FormField {
  Q_OBJECT
 public:
  ChoiceField(const FieldSite& site, QWidget* parent);
};

/// A text. The name of a thing takes along all who name it.
class TextField : public FormField {
  Q_OBJECT
 public:
  TextField(const FieldSite& site, QWidget* parent);

 private:
  void commit(const QString& typed);
};

/// The name of a thing that stands by its name in the project: a material.
class KeyField : public FormField {
  Q_OBJECT
 public:
  KeyField(const FieldSite& site, QWidget* parent);
};

/// A text that names something else in the project: chosen from what there is; pieces of solids may be typed.
class NameField : public FormField {
  Q_OBJECT
 public:
  NameField(const FieldSite& site, QWidget* parent);

 private:
  void commit(const QString& name);
};

/// A box with the names that may stand at a place; `commit` is told what was chosen or typed.
QComboBox* makeNameBox(const FieldSite& site, const std::function<void(const QString&)>& commit);

}  // namespace talus
