#include "effects/contact_law.hpp"

#include <algorithm>

namespace talus {

Vec3 relative_displacement(const ContactSet& contacts, const ContactPoint& point, const BodySet& set,
                           const Increment& d) {
  Vec3 u = Vec3::Zero();
  for (int k = point.stencil_begin; k < point.stencil_end; ++k) {
    const int freedom = set.nodes.freedom[contacts.nodes[k]];
    if (freedom >= 0)
      u += contacts.weights[k] * d.segment<3>(3 * freedom);
    else if (set.nodes.any_prescribed)
      u += contacts.weights[k] * set.nodes.prescribed[contacts.nodes[k]];
  }
  return u;
}

double normal_force(const ContactPoint& point, double gap) {
  return std::max(point.bonded ? -point.tension : 0.0, point.multiplier - point.normal_stiffness * gap);
}

bool resists_elastically(const ContactPoint& point, double gap) {
  return point.multiplier - point.normal_stiffness * gap > (point.bonded ? -point.tension : 0.0);
}

bool touches(const ContactPoint& point, double gap, double share) { return gap < share * point.size; }

double shear_strength(const ContactPoint& point, double normal_force) {
  return std::max(0.0, point.cohesion + point.friction * normal_force);
}

void subtract_contact_force(const ContactSet& contacts, const ContactPoint& point, const BodySet& set,
                            const Vec3& force, Eigen::VectorXd& sum) {
  for (int k = point.stencil_begin; k < point.stencil_end; ++k) {
    const int freedom = set.nodes.freedom[contacts.nodes[k]];
    if (freedom >= 0) sum.segment<3>(3 * freedom) -= contacts.weights[k] * force;
  }
}

double work_on_held_nodes(const ContactSet& contacts, const ContactPoint& point, const BodySet& set,
                          const Vec3& force) {
  double work = 0;
  for (int k = point.stencil_begin; k < point.stencil_end; ++k)
    work -= contacts.weights[k] * force.dot(set.nodes.prescribed[contacts.nodes[k]]);
  return work;
}

void add_contact_spring(const ContactSet& contacts, const ContactPoint& point, const BodySet& set, const Mat3& spring,
                        SymmetricBlocks& sum) {
  for (int a = point.stencil_begin; a < point.stencil_end; ++a) {
    const int i = set.nodes.freedom[contacts.nodes[a]];
    if (i < 0) continue;
    for (int b = point.stencil_begin; b <= a; ++b) {
      const int j = set.nodes.freedom[contacts.nodes[b]];
      if (j >= 0) sum.add(i, j, contacts.weights[a] * contacts.weights[b] * spring);
    }
  }
}

}  // namespace talus
