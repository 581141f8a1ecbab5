#include "solve/equilibrium/interior_point_contacts.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "solve/equilibrium/lorentz_cone.hpp"

namespace talus {

void InteriorPointContacts::begin(const ContactLinks& links, const std::vector<int>& points, const Increment& d,
                                  const Eigen::VectorXd& flight, const Increment& landed, double force) {
  links_ = &links;
  double deepest = 0, sum = 0;
  for (const int i : points) deepest = std::max({deepest, -links.gap(i, d), -links.gap(i, landed)});
  points_.clear();
  double fastest = 0;
  for (Eigen::Index n = 0; n < flight.size(); n += 3) fastest = std::max(fastest, flight.segment<3>(n).norm());
  for (const int i : points) {
    const ContactPoint& contact = links.point(i);
    const double least_gap = links.gap(i, d) + links.moves().farthest_against(i, d, contact.normal, flight);
    if (least_gap > tolerances_.flight_gap * fastest + tolerances_.least_gap * contact.size) continue;
    points_.push_back(point_at(i));
    Point& point = points_.back();
    const double least = std::max(deepest, tolerances_.least_displacement * contact.size) / point.friction;
    point.z = displacement_of(point, d);
    point.z[0] = std::max(point.z[0], least);
    const double slip = point.z.tail<2>().norm(), most = tolerances_.most_slip * point.z[0];
    if (slip > most) point.z.tail<2>() *= most / slip;
    sum += force * least * point.friction;
  }
  const double complementarity = points_.empty() ? 0 : sum / static_cast<double>(points_.size());
  for (Point& point : points_) point.x = complementarity * lorentz_cone::inverse(point.z);
}

InteriorPointContacts::Point InteriorPointContacts::point_at(int index) const {
  const ContactPoint& contact = links_->point(index);
  Point point{.index = index};
  const bool has_friction = contact.friction > 0;
  if (has_friction) point.friction = contact.friction;
  point.directions.col(0) = contact.normal / point.friction;
  point.compliance.setConstant(1 / (contact.normal_stiffness * point.friction * point.friction));
  if (has_friction) {
    point.directions.col(1) = contact.normal.unitOrthogonal();
    point.directions.col(2) = contact.normal.cross(point.directions.col(1));
    point.compliance.tail<2>().setConstant(1 / contact.shear_stiffness);
  }
  point.initial = -point.compliance.cwiseProduct(point.directions.transpose() * contact.shear_start);
  point.initial[0] = (contact.gap - contact.multiplier / contact.normal_stiffness) / point.friction;
  return point;
}

Vec3 InteriorPointContacts::displacement_of(const Point& point, const Increment& d) const {
  Vec3 displacement = point.initial + point.compliance.cwiseProduct(point.x) +
                      point.directions.transpose() * links_->moves().increment(point.index, d);
  displacement[0] += displacement.tail<2>().norm();
  return displacement;
}

void InteriorPointContacts::linearise(const Increment& d) {
  for (Point& point : points_) {
    point.displacement = displacement_of(point, d);
    point.dilation = Mat3::Identity();
    const double slip = point.displacement.tail<2>().norm();
    if (slip > 0) point.dilation.row(0).tail<2>() = point.displacement.tail<2>().transpose() / slip;
    // (H + L C)⁻¹ with the H of Nesterov & Todd, H x = z, the compliance C and the dilation L; scaled by √C before it
    // is inverted, which makes C the identity.
    const lorentz_cone::Scaling scaling(point.x, point.z);
    const Vec3 root = point.compliance.cwiseSqrt(), over = root.cwiseInverse();
    Mat3 sum = over.asDiagonal() * (scaling.inverse * scaling.inverse) * over.asDiagonal();
    sum += over.asDiagonal() * point.dilation * root.asDiagonal();
    point.response = over.asDiagonal() * sum.partialPivLu().inverse() * over.asDiagonal();
    point.tangent = point.response * point.dilation;
  }
}

void InteriorPointContacts::target_contact() {
  for (Point& point : points_) point.first = -point.response * point.displacement;
}

void InteriorPointContacts::target_complementarity(double complementarity) {
  for (Point& point : points_) {
    const lorentz_cone::Scaling scaling(point.x, point.z);
    Vec3 target =
        -lorentz_cone::product(scaling.inverse * point.force_change, scaling.matrix * point.displacement_change);
    target[0] += complementarity;
    const Vec3 change = scaling.inverse * lorentz_cone::quotient(target, scaling.scaled);
    point.first = point.response * (change - point.displacement);
  }
}

void InteriorPointContacts::add_forces(const Increment& d, Arms arms, Eigen::VectorXd& sum) const {
  for (const Point& point : points_)
    links_->moves().add_force(point.index, d, point.directions * (point.x + point.first), arms, sum);
}

void InteriorPointContacts::add_tangent(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const {
  Attachments::Tangent tangent(links_->moves(), d, arms, nullptr, &sum);
  for (const Point& point : points_)
    tangent.add(point.index,
                {.other = point.directions * point.tangent * point.directions.transpose(), .has_other = true});
}

void InteriorPointContacts::find_changes(const Increment& from, const Increment& to) {
  for (Point& point : points_) {
    const Vec3 moved = point.directions.transpose() *
                       (links_->moves().increment(point.index, to) - links_->moves().increment(point.index, from));
    point.force_change = point.first - point.tangent * moved;
    point.displacement_change =
        point.displacement - point.z + point.dilation * (point.compliance.cwiseProduct(point.force_change) + moved);
  }
}

double InteriorPointContacts::longest_step_fraction() const {
  double fraction = 1;
  for (const Point& point : points_)
    fraction = std::min({fraction, tolerances_.to_boundary * lorentz_cone::fraction_inside(point.x, point.force_change),
                         tolerances_.to_boundary * lorentz_cone::fraction_inside(point.z, point.displacement_change)});
  return fraction;
}

void InteriorPointContacts::change_by(double fraction) {
  for (Point& point : points_) {
    point.x += fraction * point.force_change;
    point.z += fraction * point.displacement_change;
  }
}

double InteriorPointContacts::mean_complementarity() const {
  double sum = 0;
  for (const Point& point : points_) sum += point.x.dot(point.z);
  return points_.empty() ? 0 : sum / static_cast<double>(points_.size());
}

}  // namespace talus
