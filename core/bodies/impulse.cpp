#include "bodies/impulse.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>

#include "bodies/finite_rotation.hpp"
#include "bodies/meeting.hpp"

namespace talus {

struct InverseMasses::Factor : Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> {
  using SimplicialLLT::SimplicialLLT;
};

InverseMasses::InverseMasses(const BodySet& set) : set_(set), factors_(set.bodies.size()) {}
InverseMasses::~InverseMasses() = default;

void InverseMasses::make(int index) {
  if (factors_[index]) return;
  const Body& body = set_.bodies[index];
  std::vector<Eigen::Triplet<double>> entries;
  for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
    const Element& element = set_.elements[e];
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        entries.emplace_back(element.nodes[a] - body.first_free(), element.nodes[b] - body.first_free(),
                             element.mass / 20 * (a == b ? 2 : 1));
  }
  Eigen::SparseMatrix<double> mass(body.free_count(), body.free_count());
  mass.setFromTriplets(entries.begin(), entries.end());
  factors_[index] = std::make_unique<Factor>(mass);
}

Eigen::VectorXd InverseMasses::velocities(int body, const Eigen::VectorXd& impulses) {
  make(body);
  return factors_[body]->solve(impulses);
}

Vec3 velocity_of(const BodySet& set, std::span<const int> nodes, std::span<const double> weights, double step) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const bool fixed = set.bodies[set.nodes.body[nodes[k]]].fixed;
    sum += weights[k] * (fixed ? Vec3(set.nodes.prescribed[nodes[k]] / step) : set.nodes.velocity[nodes[k]]);
  }
  return sum;
}

StruckPoint::StruckPoint(const BodySet& set, InverseMasses& masses, std::span<const int> nodes,
                         std::span<const double> weights, double step) {
  std::vector<int> bodies;
  for (const int node : nodes) bodies.push_back(set.nodes.body[node]);
  std::vector<int> each = bodies;
  std::sort(each.begin(), each.end());
  each.erase(std::unique(each.begin(), each.end()), each.end());
  for (const int body : each) {
    if (set.bodies[body].fixed) {
      for (std::size_t k = 0; k < nodes.size(); ++k)
        if (bodies[k] == body) driven_ += weights[k] / step * set.nodes.prescribed[nodes[k]];
    } else {
      add(set, masses, body, nodes, weights);
    }
  }
  if (turning_count_ == 2) meet(set, Meeting::carrier(weights));
  for (const Turning& body : turning()) {
    const Mat3 arm = cross_matrix(body.arm);
    mobility_ += body.weight * body.response * Mat3::Identity() - arm * body.inverse_inertia * arm;
  }
}

void StruckPoint::meet(const BodySet& set, int carrier) {
  auto [first, second] = turning_;
  if ((first.weight < 0) == (carrier == 0)) std::swap(first, second);
  turning_ = {first, second};
  turning_[1].arm =
      -(first.arm + first.weight * (set.nodes.position[first.centre] - set.nodes.position[second.centre]));
}

void StruckPoint::add(const BodySet& set, InverseMasses& masses, int index, std::span<const int> nodes,
                      std::span<const double> weights) {
  const Body& body = set.bodies[index];
  if (body.kind == BodyKind::rigid) {
    const RigidBody& rigid = set.rigid[body.rigid];
    Turning& turning = turning_[turning_count_++];
    turning = {body.rigid, rigid.centre, 0, 0, Vec3::Zero(), rigid.inertia_now().inverse()};
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (set.nodes.body[nodes[k]] != index) continue;
      turning.weight += weights[k];
      turning.arm += weights[k] * (set.nodes.position[nodes[k]] - set.nodes.position[rigid.centre]);
    }
    turning.response = turning.weight / rigid.mass;
    return;
  }
  Deforming deforming{body.first_free(), Eigen::VectorXd::Zero(body.free_count()), {}};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (set.nodes.body[nodes[k]] != index) continue;
    if (body.kind == BodyKind::affine)
      for (int c = 0; c < 4; ++c)
        deforming.weights[c] += weights[k] * set.carried[nodes[k] - body.first_node + body.first_carried][c];
    else
      deforming.weights[nodes[k] - body.first_node] += weights[k];
  }
  deforming.response = masses.velocities(index, deforming.weights);
  mobility_ += deforming.weights.dot(deforming.response) * Mat3::Identity();
  deforming_.push_back(std::move(deforming));
}

Vec3 StruckPoint::velocity(const BodySet& set) const {
  Vec3 sum = driven_;
  for (const Deforming& body : deforming_)
    for (Eigen::Index n = 0; n < body.weights.size(); ++n)
      if (body.weights[n] != 0) sum += body.weights[n] * set.nodes.velocity[body.first_node + n];
  for (const Turning& body : turning())
    sum += body.weight * set.nodes.velocity[body.centre] +
           (body.inverse_inertia * set.rigid[body.rigid].angular_momentum).cross(body.arm);
  return sum;
}

void StruckPoint::strike(BodySet& set, const Vec3& impulse) const {
  for (const Deforming& body : deforming_)
    for (Eigen::Index n = 0; n < body.response.size(); ++n)
      set.nodes.velocity[body.first_node + n] += body.response[n] * impulse;
  for (const Turning& body : turning()) {
    set.nodes.velocity[body.centre] += body.response * impulse;
    set.rigid[body.rigid].angular_momentum += body.arm.cross(impulse);
  }
}

}  // namespace talus
