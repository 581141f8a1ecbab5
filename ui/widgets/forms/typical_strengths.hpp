#pragma once

#include "widgets/forms/field.hpp"

namespace talus {

/// Strengths of joints that others have measured, to begin with: a choice of one sets friction, residual friction and
/// cohesion of a joint, in one step. Each says where it is from (resources/presets/joint_strengths.json).
class TypicalStrengths : public FormField {
  Q_OBJECT
 public:
  /// `joint`: the place of a joint of the project.
  explicit TypicalStrengths(const FieldSite& joint);

 private:
  void choose(const Json& strength);
};

}  // namespace talus
