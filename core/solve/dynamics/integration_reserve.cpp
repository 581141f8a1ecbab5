#include "solve/dynamics/integration_reserve.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "bodies/consistent_mass.hpp"

namespace talus {

IntegrationReserve::IntegrationReserve(BodySet& set)
    : set_(set), held_(set.bodies.size(), 0), begun_with_(set.bodies.size(), 1) {}

void IntegrationReserve::measure(const StepContext& step, std::vector<double>& reserves) const {
  reserves.assign(set_.bodies.size(), 0);
  if (step.dynamic_factor == 0 || !step.integration.carries_acceleration()) return;
  const double scale = (step.integration.beta - step.integration.gamma / 2) / 2 * step.length * step.length;
  for (const int r : set_.turning) {
    const RigidBody& body = set_.rigid[r];
    reserves[set_.nodes.body[body.centre]] = scale * (body.mass * set_.nodes.acceleration[body.centre].squaredNorm() +
                                                      body.moment.dot(body.inertia_now().inverse() * body.moment));
  }
  for (const Element& element : set_.elements) {
    Corners a;
    for (int i = 0; i < 4; ++i) a[i] = set_.nodes.acceleration[element.nodes[i]];
    reserves[element.body] += scale * mass_square(element.mass, a);
  }
}

void IntegrationReserve::begin_from(const StepContext& step) {
  length_ = step.length;
  begun_with_.assign(begun_with_.size(), 1);
  any_limited_ = false;
}

void IntegrationReserve::give(const StepContext& step, double longest) {
  measure(step, held_);
  for (double& held : held_) held *= std::pow(longest / step.length, 2);
  begin_from(step);
  for (const int b : set_.moving)
    if (set_.bodies[b].constant_acceleration) held_[b] = 0;
}

void IntegrationReserve::begin_step(const StepContext& step) {
  if (step.length <= length_ && !any_limited_) return;
  measure(step, at_start_);
  any_limited_ = false;
  for (const int b : set_.moving) {
    double& part = begun_with_[b];
    if (set_.bodies[b].constant_acceleration || part == 0) continue;
    const double whole = at_start_[b] / (part * part);
    const double paid = whole > held_[b] ? std::sqrt(held_[b] / whole) : 1;
    if (paid != part) set_.scale_acceleration(b, paid / part);
    part = paid;
    any_limited_ = any_limited_ || part < 1;
  }
}

void IntegrationReserve::hold(const StepContext& step, double longest) {
  measure(step, at_end_);
  begin_from(step);
  const double growth = std::pow(longest / step.length, 2);
  for (const int b : set_.moving) {
    const bool holds = !set_.bodies[b].constant_acceleration;
    const double paid = std::min(held_[b], growth * at_start_[b]) + at_end_[b] - at_start_[b];
    held_[b] = holds ? std::max(0.0, paid) : 0;
  }
}

void IntegrationReserve::release(std::span<const int> bodies, double energy) {
  double held = 0;
  for (const int b : bodies) held += held_[b];
  if (energy <= 0 || held == 0) return;
  const double left = std::max(0.0, 1 - energy / held);
  for (const int b : bodies) {
    held_[b] *= left;
    set_.scale_acceleration(b, std::sqrt(left));
  }
}

double IntegrationReserve::total() const { return std::accumulate(held_.begin(), held_.end(), 0.0); }

}  // namespace talus
