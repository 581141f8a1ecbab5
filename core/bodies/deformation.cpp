#include "bodies/deformation.hpp"

namespace talus {

namespace {

Mat3 gradient_of(const ElementShape& shape, const Corners& values) {
  Mat3 slope = Mat3::Zero();  // differences to corner 0, so that a translation changes no bit
  for (int r = 1; r < 4; ++r) slope += (values[r] - values[0]) * shape.gradient[r].transpose();
  return slope;
}

}  // namespace

Mat3 deformation_gradient(const BodySet& set, const Element& element, const ElementShape& shape) {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners[i] = set.nodes.position[element.nodes[i]];
  return gradient_of(shape, corners);
}

Mat3 deformation_gradient(const BodySet& set, const Element& element, const ElementShape& shape, const Increment& d) {
  return deformation_gradient(set, element, shape) + change_of_gradient(set, element, shape, d);
}

Mat3 change_of_gradient(const BodySet& set, const Element& element, const ElementShape& shape, const Increment& d) {
  return gradient_of(shape, set.corner_increments(element, d));
}

Voigt voigt(const Mat3& t) {
  Voigt v;
  v << t(0, 0), t(1, 1), t(2, 2), 0.5 * (t(0, 1) + t(1, 0)), 0.5 * (t(1, 2) + t(2, 1)), 0.5 * (t(2, 0) + t(0, 2));
  return v;
}

Mat3 tensor(const Voigt& s) {
  Mat3 t;
  t << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return t;
}

}  // namespace talus
