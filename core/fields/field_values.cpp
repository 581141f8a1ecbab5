#include "fields/field_values.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/units.hpp"
#include "bodies/block_pose.hpp"
#include "fields/contact_areas.hpp"
#include "fields/rock_safety.hpp"

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

/// Of a deformation gradient.
double strain_measure(const Mat3& gradient, Measure measure) {
  if (measure == Measure::volumetric) return gradient.determinant() - 1;
  const Mat3 strain = 0.5 * (gradient.transpose() * gradient - Mat3::Identity());
  const Vec3 principal = Eigen::SelfAdjointEigenSolver<Mat3>(strain, Eigen::EigenvaluesOnly).eigenvalues();
  if (measure == Measure::max_principal) return principal[2];
  return measure == Measure::min_principal ? principal[0] : principal[2] - principal[0];
}

SleepState sleep_state(const Block& block, bool sleeps) {
  if (block.body == BodyKind::fixed) return SleepState::fixed;
  return sleeps ? SleepState::asleep : SleepState::awake;
}

bool compares_walls(const Field& field) { return field.measure == Measure::slip || field.measure == Measure::opening; }

bool needs_strength(const Field& field) {
  return field.measure == Measure::mobilised || field.measure == Measure::cohesion || field.measure == Measure::bond;
}

}  // namespace

std::string why_absent(const BlockSystem& system, const Frame& frame, const Field& field) {
  if (field.measure == Measure::sleep && frame.asleep.empty())
    return "which blocks sleep is not recorded in these results: an earlier version of Talus has written them";
  const auto has = [](const std::optional<RockStrength>& strength) { return strength.has_value(); };
  if (field.measure == Measure::safety && !std::ranges::any_of(system.strengths, has))
    return "no material has a strength: give one to the rock on the page Materials";
  if (field.measure == Measure::motion && frame.motions.empty()) return "how blocks move was not noted in this frame";
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
  if (field.source == Field::Source::strain) return strains(frame, field);
  if (field.measure == Measure::safety) return safeties(frame);
  if (field.place() == FieldPlace::block) return of_blocks(frame, field);
  return field.place() == FieldPlace::wall ? of_walls(frame, field) : values(frame, field);
}

std::vector<double> FieldValues::of_blocks(const Frame& frame, const Field& field) const {
  std::vector<double> result;
  std::size_t first = 0;
  for (std::size_t b = 0; b < system_.blocks.size(); ++b) {
    const Block& block = system_.blocks[b];
    if (field.measure == Measure::body) {
      result.push_back(static_cast<double>(block.body));
    } else if (field.measure == Measure::sleep) {
      result.push_back(frame.asleep.empty() ? none : static_cast<double>(sleep_state(block, frame.asleep[b] != 0)));
    } else if (field.measure == Measure::motion) {
      result.push_back(frame.motions.empty() ? none : static_cast<double>(frame.motions[b].mode));
    } else {
      if (!poses_) poses_ = std::make_unique<const PoseFit>(system_);
      std::vector<Vec3> moved = block.mesh.nodes;
      for (std::size_t n = 0; n < moved.size(); ++n) moved[n] += frame.displacement[first + n];
      const Mat3 turned = poses_->pose(static_cast<int>(b), block.mesh.nodes.data(), moved.data()).rotation;
      result.push_back(degrees(Eigen::AngleAxisd(turned).angle()));
    }
    first += block.mesh.nodes.size();
  }
  return result;
}

std::vector<double> FieldValues::safeties(const Frame& frame) const {
  std::vector<double> result;
  for (const Block& block : system_.blocks) {
    const auto material = static_cast<std::size_t>(block.material);
    const bool has_stress = block.body == BodyKind::affine || block.body == BodyKind::tetrahedra;
    const bool is_known = has_stress && material < system_.strengths.size() && system_.strengths[material];
    for (std::size_t t = 0; t < block.mesh.tetrahedra.size(); ++t)
      result.push_back(is_known ? rock_safety(frame.stress[result.size()], *system_.strengths[material]) : none);
  }
  return result;
}

std::vector<double> FieldValues::strains(const Frame& frame, const Field& field) const {
  constexpr double rounding = 1e-12;
  std::vector<double> result;
  std::size_t first = 0;
  for (const Block& block : system_.blocks) {
    for (const auto& nodes : block.mesh.tetrahedra) {
      Mat3 rest, moved;
      const auto at = [&](int i) { return static_cast<std::size_t>(nodes[static_cast<std::size_t>(i)]); };
      for (int i = 0; i < 3; ++i) {
        rest.col(i) = block.mesh.nodes[at(i + 1)] - block.mesh.nodes[at(0)];
        moved.col(i) = rest.col(i) + frame.displacement[first + at(i + 1)] - frame.displacement[first + at(0)];
      }
      const double value = strain_measure(moved * rest.inverse(), field.measure);
      result.push_back(std::abs(value) < rounding ? 0 : value);
    }
    first += block.mesh.nodes.size();
  }
  return result;
}

std::vector<double> FieldValues::of_walls(const Frame& frame, const Field& field) const {
  const JointWalls& all = walls();
  std::vector<double> result(all.points.size(), none);
  if (!why_absent(system_, frame, field).empty()) return result;
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
    const Vec3 at = rest_of(system_.blocks[block], first_node[block], point.place) + point.place.of(frame.displacement);
    const auto traction = areas.at(at, normal_in(system_, first_node[block], point, frame), point.block);
    return traction ? told(*traction, field.measure) : none;
  });
  return result;
}

}  // namespace talus
