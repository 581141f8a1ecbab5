#include "verification/known_answers/wedges/wedge_motion.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"

namespace talus {

namespace {

constexpr double start_of_way = 0.05, end_of_way = 0.10;  // lengths of the wedge
/// A plane carries the wedge when it bears, on average, this share of the weight. The least that limit equilibrium
/// finds in the tests is 1.2 % (B2-80-50).
constexpr double carrying_share = 1e-3;
/// Contact normals lie on a plane within this angle [degrees].
constexpr double plane_tolerance = 3;
/// Turning displaces the far end of the wedge by at least this fraction of its displacement: more than a translation.
constexpr double torsional_share = 0.1;
/// The wedge lies still below this speed, of √(gravity · length), once that time was enough to get going.
constexpr double still_speed = 1e-6;

}  // namespace

WedgeWatch::WedgeWatch(const CaseScene& scene, const WedgePlanes& planes, double length)
    : planes_(planes), length_(length), gravity_(scene.project.gravity.norm()) {
  const Block& wedge = scene.system.blocks[1];
  weight_ = scene.project.materials[wedge.material].density * wedge.volume * gravity_;
}

bool WedgeWatch::look(const Simulation& simulation, const StepReport& report) {
  ++steps_;
  iterations_ += report.iterations;
  const BlockMotion motion = block_motion(simulation.bodies(), 1);
  last_ = {motion.displacement, motion.rotation};
  const double travel = motion.displacement.norm();
  if (start_) add_forces(simulation);
  if (!start_ && travel > start_of_way * length_) start_ = last_;
  const bool still = simulation.time() > std::sqrt(length_ / gravity_) &&
                     motion.velocity.norm() < still_speed * std::sqrt(gravity_ * length_);
  return travel < end_of_way * length_ && !still;
}

void WedgeWatch::add_forces(const Simulation& simulation) {
  ++looks_;
  const double along_normal = std::cos(radians(plane_tolerance));
  for (const ContactSample& contact : simulation.contacts()) {
    double* sum = &on_neither_;
    for (int plane = 0; plane < 2; ++plane)
      if (std::abs(contact.normal.dot(planes_.normals[plane])) > along_normal) sum = &on_plane_[plane];
    *sum += contact.normal_force;
  }
}

WedgeMotion WedgeWatch::motion() const {
  WedgeMotion motion;
  motion.travel = last_.displacement.norm() / length_;
  motion.steps = steps_;
  motion.iterations = iterations_;
  if (!start_ || looks_ == 0) return motion;
  motion.direction = (last_.displacement - start_->displacement).normalized();
  motion.turn = last_.rotation - start_->rotation;
  const double all = on_plane_[0] + on_plane_[1] + on_neither_;
  motion.stray = all > 0 ? on_neither_ / all : 0;
  motion.mode = mode(motion);
  return motion;
}

WedgeMode WedgeWatch::mode(const WedgeMotion& motion) const {
  const auto carries = [&](int plane) { return on_plane_[plane] > carrying_share * weight_ * looks_; };
  if (carries(0) && carries(1)) return motion.direction.dot(planes_.line) > 0 ? WedgeMode::line_1 : WedgeMode::line_2;
  if (carries(0)) return WedgeMode::plane_1;
  if (!carries(1)) return WedgeMode::free_fall;
  const double distance = (last_.displacement - start_->displacement).norm();
  return motion.turn * length_ > torsional_share * distance ? WedgeMode::torsional : WedgeMode::plane_2;
}

}  // namespace talus
