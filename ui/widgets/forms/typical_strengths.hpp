#pragma once

#include <vector>

#include "widgets/forms/field.hpp"

class QVBoxLayout;

namespace talus {

/// Strengths and stiffnesses of joints that others have measured, to begin with: a choice of one sets friction,
/// residual friction and cohesion of a joint, or both of its stiffnesses, in one step. Each says where it is from
/// (resources/presets/joint_strengths.json).
class TypicalStrengths : public FormField {
  Q_OBJECT
 public:
  /// `joint`: the place of a joint of the project.
  TypicalStrengths(const FieldSite& joint, QWidget* parent);

 private:
  using Keys = std::vector<const char*>;
  /// A row that sets these values, all or none of which a joint has, from groups of the presets.
  QWidget* makeChoice(const QString& title, const QString& name, const char* groups, const Keys& keys);
  void choose(const Json& values, const Keys& keys);
};

}  // namespace talus
