#include "effects/interior_contacts.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "effects/lorentz_cone.hpp"

namespace talus {

namespace {

/// Of the size of a point: no way begins with less.
constexpr double least_way = 1e-7;
/// Of the way off contact, over μ: no slip begins with more.
constexpr double most_slip = 0.5;
/// Of the share at which the first point would reach the boundary of its cone.
constexpr double nearly_all = 0.99;

/// Points stay out that would be further apart, on their way to free flight, than this share of the fastest flight …
constexpr double kicked = 0.25;
/// … and this share of their size. Others may be pushed by what is pushed.
constexpr double close_by = 1e-3;

}  // namespace

void InteriorContacts::begin(const ContactLinks& links, const Increment& d, const Eigen::VectorXd& flight,
                             double force) {
  links_ = &links;
  const ContactSet& contacts = links.contacts();
  double deepest = 0, sum = 0;
  for (const int i : contacts.loose) deepest = std::max(deepest, -links.gap(i, d));
  points_.clear();
  double fastest = 0;
  for (Eigen::Index n = 0; n < flight.size(); n += 3) fastest = std::max(fastest, flight.segment<3>(n).norm());
  for (const int i : contacts.loose) {
    const ContactPoint& contact = links.point(i);
    const double least_gap = links.gap(i, d) + links.moves().farthest_against(i, d, contact.normal, flight);
    if (least_gap > kicked * fastest + close_by * contact.size) continue;
    points_.push_back(point_at(i));
    Point& point = points_.back();
    const double least = std::max(deepest, least_way * contact.size) / point.friction;
    point.z = way_of(point, d);
    point.z[0] = std::max(point.z[0], least);
    const double slip = point.z.tail<2>().norm(), most = most_slip * point.z[0];
    if (slip > most) point.z.tail<2>() *= most / slip;
    sum += force * least * point.friction;
  }
  const double product = points_.empty() ? 0 : sum / static_cast<double>(points_.size());
  for (Point& point : points_) point.x = product * lorentz_cone::inverse(point.z);
}

InteriorContacts::Point InteriorContacts::point_at(int index) const {
  const ContactPoint& contact = links_->point(index);
  Point point{.index = index};
  const bool rubs = contact.friction > 0;
  if (rubs) point.friction = contact.friction;
  point.directions.col(0) = contact.normal / point.friction;
  point.compliance.setConstant(1 / (contact.normal_stiffness * point.friction * point.friction));
  if (rubs) {
    point.directions.col(1) = contact.normal.unitOrthogonal();
    point.directions.col(2) = contact.normal.cross(point.directions.col(1));
    point.compliance.tail<2>().setConstant(1 / contact.shear_stiffness);
  }
  point.apart = -point.compliance.cwiseProduct(point.directions.transpose() * contact.shear_start);
  point.apart[0] = (contact.gap - contact.multiplier / contact.normal_stiffness) / point.friction;
  return point;
}

Vec3 InteriorContacts::way_of(const Point& point, const Increment& d) const {
  Vec3 way = point.apart + point.compliance.cwiseProduct(point.x) +
             point.directions.transpose() * links_->moves().increment(point.index, d);
  way[0] += way.tail<2>().norm();
  return way;
}

void InteriorContacts::linearise(const Increment& d) {
  for (Point& point : points_) {
    point.way = way_of(point, d);
    point.lifting = Mat3::Identity();
    const double slip = point.way.tail<2>().norm();
    if (slip > 0) point.lifting.row(0).tail<2>() = point.way.tail<2>().transpose() / slip;
    // With the H by which H x = z that Newton's method asks for, the compliance C and the lifting L: (H + L C)⁻¹,
    // inverted with what C makes 1 of C.
    const lorentz_cone::Scaling scaling(point.x, point.z);
    const Vec3 root = point.compliance.cwiseSqrt(), over = root.cwiseInverse();
    Mat3 sum = over.asDiagonal() * (scaling.inverse * scaling.inverse) * over.asDiagonal();
    sum += over.asDiagonal() * point.lifting * root.asDiagonal();
    point.response = over.asDiagonal() * sum.partialPivLu().inverse() * over.asDiagonal();
    point.tangent = point.response * point.lifting;
  }
}

void InteriorContacts::aim_at_contact() {
  for (Point& point : points_) point.first = -point.response * point.way;
}

void InteriorContacts::aim_at(double product) {
  for (Point& point : points_) {
    const lorentz_cone::Scaling scaling(point.x, point.z);
    Vec3 wanted = -lorentz_cone::product(scaling.inverse * point.force_change, scaling.matrix * point.way_change);
    wanted[0] += product;
    const Vec3 way = scaling.inverse * lorentz_cone::quotient(wanted, scaling.scaled);
    point.first = point.response * (way - point.way);
  }
}

void InteriorContacts::add_forces(const Increment& d, Eigen::VectorXd& sum) const {
  for (const Point& point : points_)
    links_->moves().add_force(point.index, d, point.directions * (point.x + point.first), sum);
}

void InteriorContacts::add_tangent(const Increment& d, UnsymmetricBlocks& sum) const {
  const Attachments& moves = links_->moves();
  for (const Point& point : points_) {
    const Mat3 spring = point.directions * point.tangent * point.directions.transpose();
    moves.add_spring(point.index, d, spring, sum);
    if (!moves.any_turns()) continue;
    moves.add_turning(point.index, d, -point.directions * point.x, sum);
    moves.add_lever_difference(point.index, d, spring, sum);
  }
}

void InteriorContacts::find_changes(const Increment& from, const Increment& to) {
  for (Point& point : points_) {
    const Vec3 moved = point.directions.transpose() *
                       (links_->moves().increment(point.index, to) - links_->moves().increment(point.index, from));
    point.force_change = point.first - point.tangent * moved;
    point.way_change =
        point.way - point.z + point.lifting * (point.compliance.cwiseProduct(point.force_change) + moved);
  }
}

double InteriorContacts::longest_share() const {
  double share = 1;
  for (const Point& point : points_)
    share = std::min({share, nearly_all * lorentz_cone::share_inside(point.x, point.force_change),
                      nearly_all * lorentz_cone::share_inside(point.z, point.way_change)});
  return share;
}

void InteriorContacts::change_by(double share) {
  for (Point& point : points_) {
    point.x += share * point.force_change;
    point.z += share * point.way_change;
  }
}

double InteriorContacts::mean_product() const {
  double sum = 0;
  for (const Point& point : points_) sum += point.x.dot(point.z);
  return points_.empty() ? 0 : sum / static_cast<double>(points_.size());
}

}  // namespace talus
