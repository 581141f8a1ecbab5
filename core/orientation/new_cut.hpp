#pragma once

#include <string>

#include "model/project.hpp"
#include "orientation/attitude.hpp"

namespace talus {

/// The project with one more cut, at the end of its list: angles rounded to 0.01°, the point to a millimetre. It is of
/// this joint; of the default joint, or the first one, where that is empty; where the project has none, one is added
/// with a friction angle of 30°.
Project with_cut(Project project, const PlaneAttitude& plane, const Vec3& through, const std::string& joint);

/// The project with this joint between two blocks; what was said of them before is replaced.
Project with_interface(Project project, const std::string& one, const std::string& two, const std::string& joint);

}  // namespace talus
