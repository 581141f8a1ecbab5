#include "fields/contact_areas.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double same_direction = 0.985;  // cosine of 10°
constexpr double near_of_block = 0.01;    // of a block's size: contacts are told where they were when the step began

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Counter-clockwise (Andrew 1979); less than three corners where the points lie on a line.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  std::vector<Vec2> hull;
  const auto grow = [&hull](const Vec2& point, std::size_t fixed) {
    while (hull.size() >= fixed + 2 && cross(hull.back() - hull[hull.size() - 2], point - hull[hull.size() - 2]) <= 0)
      hull.pop_back();
    hull.push_back(point);
  };
  for (const Vec2& point : points) grow(point, 0);
  const std::size_t below = hull.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) grow(*point, below);
  hull.pop_back();
  return hull;
}

bool lies_in(const std::vector<Vec2>& hull, const Vec2& point, double near) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 along = hull[(i + 1) % hull.size()] - hull[i];
    if (cross(along, point - hull[i]) < -near * along.norm()) return false;
  }
  return true;
}

}  // namespace

Vec2 ContactArea::flat(const Vec3& place) const { return {x_.dot(place - origin_), y_.dot(place - origin_)}; }

/// Once all points are there.
void ContactArea::close() {
  Vec3 normal = Vec3::Zero();
  for (const Point& point : points_) normal += point.contact->area * point.contact->normal;
  normal_ = normal.normalized();
  origin_ = points_.front().contact->position;
  x_ = normal_.unitOrthogonal();
  y_ = normal_.cross(x_);
  std::vector<Vec2> flat_points;
  for (Point& point : points_) flat_points.push_back(point.at = flat(point.contact->position));
  if (points_.size() >= 3) hull_ = convex_hull(std::move(flat_points));
  if (hull_.size() < 3) hull_.clear();
}

std::optional<JointTraction> ContactArea::at(const Vec3& place, const Vec3& outward, int block) const {
  const Vec3 to_other = block == blocks_[0] ? Vec3(-normal_) : normal_;
  if (hull_.empty() || outward.dot(to_other) < same_direction) return {};
  if (std::abs(normal_.dot(place - origin_)) > near_) return {};
  const Vec2 here = flat(place);
  if (!lies_in(hull_, here, near_)) return {};

  double area = 0, normal = 0, strength = 0, cohesion = 0, nearest = std::numeric_limits<double>::infinity();
  Vec3 shear = Vec3::Zero();
  JointTraction result;
  for (const Point& point : points_) {
    const ContactSample& contact = *point.contact;
    const double distance = (point.at - here).squaredNorm(), weight = 1 / (distance + 1e-6 * contact.area);
    area += weight * contact.area;
    normal += weight * contact.normal_force;
    shear += weight * contact.shear_force;
    cohesion += weight * contact.area * contact.cohesion;
    strength += weight * std::max(0.0, contact.area * contact.cohesion + contact.friction * contact.normal_force);
    if (distance >= nearest) continue;
    nearest = distance;
    result.state = contact.state;
    result.bond = contact.bond;
  }
  result.normal = normal / area;
  result.shear = shear.norm() / area;
  result.strength = strength / area;
  result.cohesion = cohesion / area;
  return result;
}

ContactAreas::ContactAreas(std::span<const double> sizes, const Frame& frame) : sizes_(sizes), of_block_(sizes.size()) {
  for (const ContactSample& contact : frame.contacts)
    if (contact.area > 0) add(contact);
  for (ContactArea& area : areas_) area.close();
}

void ContactAreas::add(const ContactSample& contact) {
  const auto size = [this](int block) { return sizes_[static_cast<std::size_t>(block)]; };
  const double same_plane = near_of_block * std::min(size(contact.blocks[0]), size(contact.blocks[1]));
  for (const int number : of_block_[static_cast<std::size_t>(contact.blocks[0])]) {
    ContactArea& area = areas_[static_cast<std::size_t>(number)];
    const ContactSample& first = *area.points_.front().contact;
    if (first.blocks[0] != contact.blocks[0] || first.blocks[1] != contact.blocks[1] || first.joint != contact.joint)
      continue;
    if (first.normal.dot(contact.normal) < same_direction ||
        std::abs(first.normal.dot(contact.position - first.position)) > same_plane)
      continue;
    area.points_.push_back({Vec2::Zero(), &contact});
    return;
  }
  const int number = static_cast<int>(areas_.size());
  ContactArea& area = areas_.emplace_back();
  area.blocks_ = {contact.blocks[0], contact.blocks[1]};
  area.near_ = same_plane;
  area.points_.push_back({Vec2::Zero(), &contact});
  for (const int block : contact.blocks) of_block_[static_cast<std::size_t>(block)].push_back(number);
}

std::optional<JointTraction> ContactAreas::at(const Vec3& place, const Vec3& outward, int block) const {
  for (const int number : of_block_[static_cast<std::size_t>(block)])
    if (const auto found = areas_[static_cast<std::size_t>(number)].at(place, outward, block)) return found;
  return {};
}

}  // namespace talus
