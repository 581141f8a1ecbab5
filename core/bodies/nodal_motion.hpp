#pragma once

#include "bodies/body_set.hpp"
#include "bodies/step_context.hpp"

/// What the integrator makes of a node's increment, TimeIntegration.
namespace talus {

/// β of a body. Where a₀ = a₁, whatever the integrator, it is ½.
inline double beta_of(const Body& body, const StepContext& step) {
  return body.constant_acceleration ? 0.5 : step.integration.beta;
}
inline double beta_of(const BodySet& set, const StepContext& step, int node) {
  return beta_of(set.bodies[set.nodes.body[node]], step);
}

/// a₀ of a node as it enters the step [m/s²].
inline Vec3 start_acceleration(const BodySet& set, const StepContext& step, int node) {
  return step.dynamic_factor * set.nodes.acceleration[node];
}

/// a₁ of a node that has unknowns: (D − Δ v₀ − (½ − β) Δ² a₀) / (βΔ²) [m/s²].
inline Vec3 end_acceleration(const BodySet& set, const StepContext& step, int node, const Increment& d) {
  const double beta = beta_of(set, step, node), length = step.length;
  const Vec3 free = length * step.dynamic_factor * set.nodes.velocity[node] +
                    (0.5 - beta) * length * length * start_acceleration(set, step, node);
  return (d.segment<3>(3 * set.nodes.dof_block[node]) - free) / (beta * length * length);
}

}  // namespace talus
