#pragma once

#include "bodies/body_set.hpp"

namespace talus {

/// Deformation gradient F of an element whose `shape` is the undeformed one, where its corners stand.
Mat3 deformation_gradient(const BodySet& set, const Element& element, const ElementShape& shape);
/// The same once they have moved on by `d`. An increment far below the rounding of a position still counts.
Mat3 deformation_gradient(const BodySet& set, const Element& element, const ElementShape& shape, const Increment& d);
/// By how much an increment changes it.
Mat3 change_of_gradient(const BodySet& set, const Element& element, const ElementShape& shape, const Increment& d);

/// xx, yy, zz, xy, yz, zx of the symmetric part of a tensor, and a symmetric tensor of those.
Voigt voigt(const Mat3& tensor);
Mat3 tensor(const Voigt& stress);

}  // namespace talus
