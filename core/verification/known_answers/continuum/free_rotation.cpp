#include "verification/known_answers/continuum/free_rotation.hpp"

#include <Eigen/Geometry>

namespace talus {

namespace {

Vec3 euler_rate(const Vec3& moments, const Vec3& w) {
  return {(moments[1] - moments[2]) / moments[0] * w[1] * w[2], (moments[2] - moments[0]) / moments[1] * w[2] * w[0],
          (moments[0] - moments[1]) / moments[2] * w[0] * w[1]};
}

Vec3 after_step(const Vec3& moments, const Vec3& w, double step) {
  const Vec3 k1 = euler_rate(moments, w), k2 = euler_rate(moments, w + step / 2 * k1),
             k3 = euler_rate(moments, w + step / 2 * k2), k4 = euler_rate(moments, w + step * k3);
  return w + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

}  // namespace

Vec3 free_angular_velocity(const Vec3& moments, const Vec3& initial, double time, int steps) {
  Vec3 w = initial;
  for (int i = 0; i < steps; ++i) w = after_step(moments, w, time / steps);
  return w;
}

std::vector<double> zero_crossings(const Vec3& moments, const Vec3& initial, int axis, int count) {
  std::vector<double> crossings;
  const double step = 1e-3 / initial.norm();
  Vec3 w = initial;
  for (long i = 0; static_cast<int>(crossings.size()) < count; ++i) {
    const Vec3 next = after_step(moments, w, step);
    if (w[axis] * next[axis] < 0)
      crossings.push_back(step * (static_cast<double>(i) + w[axis] / (w[axis] - next[axis])));
    w = next;
  }
  return crossings;
}

Vec3 angular_momentum(const BodySet& bodies) {
  Vec3 sum = Vec3::Zero();
  for (const Element& element : bodies.elements) {
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
    for (const int node : element.nodes) {
      place += bodies.nodes.position[node];
      velocity += bodies.nodes.velocity[node];
      sum += element.mass / 20 * bodies.nodes.position[node].cross(bodies.nodes.velocity[node]);
    }
    sum += element.mass / 20 * place.cross(velocity);
  }
  for (const int r : bodies.turning) {
    const RigidBody& body = bodies.rigid[r];
    sum += body.angular_momentum +
           body.mass * bodies.nodes.position[body.centre].cross(bodies.nodes.velocity[body.centre]);
  }
  return sum;
}

}  // namespace talus
