#include "fields/field_values.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "fields/contact_areas.hpp"

namespace talus {

namespace {

using Measure = Field::Measure;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int points_worth_a_thread = 2000;

/// The wall's outward unit normal in the frame.
Vec3 normal_in(const BlockSystem& system, std::size_t first_node, const WallPoint& point, const Frame& frame) {
  std::array<Vec3, 3> at;
  const Block& block = system.blocks[static_cast<std::size_t>(point.block)];
  for (std::size_t i = 0; i < 3; ++i) {
    const auto node = static_cast<std::size_t>(point.place.nodes[i]);
    at[i] = block.mesh.nodes[node - first_node] + frame.displacement[node];
  }
  return (at[1] - at[0]).cross(at[2] - at[0]).normalized();
}

Vec3 rest_of(const Block& block, std::size_t first_node, const SurfacePlace& place) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i)
    sum += place.weights[static_cast<int>(i)] * block.mesh.nodes[static_cast<std::size_t>(place.nodes[i]) - first_node];
  return sum;
}

WallState state_of(ContactState state) {
  switch (state) {
    case ContactState::stick:
      return WallState::sticks;
    case ContactState::slip:
      return WallState::slides;
    case ContactState::open:
      break;
  }
  return WallState::open;
}

double told(const JointTraction& traction, Measure measure) {
  switch (measure) {
    case Measure::normal:
      return traction.normal;
    case Measure::shear:
      return traction.shear;
    case Measure::mobilised:
      return traction.strength > 0 ? std::min(1.0, traction.shear / traction.strength) : none;
    case Measure::cohesion:
      return traction.cohesion;
    case Measure::state:
      return static_cast<double>(traction.bond == Bond::whole ? WallState::bonded : state_of(traction.state));
    case Measure::bond:
      return static_cast<double>(traction.bond);
    default:
      return none;
  }
}

bool compares_walls(const Field& field) { return field.measure == Measure::slip || field.measure == Measure::opening; }

bool needs_strength(const Field& field) {
  return field.measure == Measure::mobilised || field.measure == Measure::cohesion || field.measure == Measure::bond;
}

}  // namespace

std::string why_absent(const Frame& frame, const Field& field) {
  if (field.source != Field::Source::joint || !needs_strength(field)) return {};
  const auto lacks = [](const ContactSample& contact) { return std::isnan(contact.friction); };
  if (!std::ranges::any_of(frame.contacts, lacks)) return {};
  return "these results do not tell of the strength of joints: an earlier version of Talus has written them";
}

FieldValues::FieldValues(const BlockSystem& system) : system_(system) {
  for (const Block& block : system.blocks) {
    Eigen::AlignedBox3d box;
    for (const Vec3& node : block.mesh.nodes) box.extend(node);
    sizes_.push_back(box.isEmpty() ? 0 : box.diagonal().norm());
  }
}
FieldValues::~FieldValues() = default;

const JointWalls& FieldValues::walls() const {
  if (!walls_) walls_ = std::make_unique<const JointWalls>(joint_walls(system_));
  return *walls_;
}

std::vector<double> FieldValues::of(const Frame& frame, const Field& field) const {
  return field.place() == FieldPlace::wall ? of_walls(frame, field) : values(frame, field);
}

std::vector<double> FieldValues::of_walls(const Frame& frame, const Field& field) const {
  const JointWalls& all = walls();
  std::vector<double> result(all.points.size(), none);
  if (!why_absent(frame, field).empty()) return result;
  const auto each = [&](const auto& value) {
    in_parallel(static_cast<int>(result.size()), points_worth_a_thread, [&](int begin, int end) {
      for (int i = begin; i < end; ++i)
        result[static_cast<std::size_t>(i)] = value(all.points[static_cast<std::size_t>(i)]);
    });
  };
  if (compares_walls(field)) {
    each([&](const WallPoint& point) {
      if (point.opposite < 0) return none;
      const Vec3 apart = point.across.of(frame.displacement) - point.place.of(frame.displacement);
      const double opening = apart.dot(point.normal);
      return field.measure == Measure::opening ? opening : (apart - opening * point.normal).norm();
    });
    return result;
  }
  std::vector<std::size_t> first_node;
  std::size_t nodes = 0;
  for (const Block& block : system_.blocks) {
    first_node.push_back(nodes);
    nodes += block.mesh.nodes.size();
  }
  const ContactAreas areas(sizes_, frame);
  each([&](const WallPoint& point) {
    if (!areas.touches(point.block)) return none;
    const auto block = static_cast<std::size_t>(point.block);
    const Vec3 at =
        rest_of(system_.blocks[block], first_node[block], point.place) + point.place.of(frame.displacement);
    const auto traction = areas.at(at, normal_in(system_, first_node[block], point, frame), point.block);
    return traction ? told(*traction, field.measure) : none;
  });
  return result;
}

}  // namespace talus
