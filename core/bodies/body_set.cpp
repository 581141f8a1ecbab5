#include "bodies/body_set.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <stdexcept>

#include "base/parallel.hpp"
#include "bodies/finite_rotation.hpp"
#include "bodies/rigid_motion.hpp"
#include "bodies/time_integration.hpp"
#include "mesh/moments.hpp"

namespace talus {

namespace {

constexpr int bodies_worth_a_thread = 128;  // that are rigid, with a dozen nodes each

Body make_body(const Block& block, const Material& material) {
  Body body;
  body.kind = block.body;
  body.node_count = static_cast<int>(block.mesh.nodes.size());
  body.fixed = body.built_fixed();
  body.density = material.density;
  body.young = material.young;
  body.elastic = Elastic::of(material);
  body.law = material.law;
  return body;
}

/// Corners of the tetrahedron of the same mass, centroid and moments of inertia as the block: its consistent mass,
/// which knows of a body no more than these, is the block's.
Corners equivalent_tetrahedron(const VolumeMoments& moments) {
  const Mat3 root = std::sqrt(5.0) * Eigen::SelfAdjointEigenSolver<Mat3>(moments.spread).operatorSqrt();
  Corners corners{Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, -1, 1), Vec3(-1, 1, -1)};
  for (Vec3& corner : corners) corner = moments.centroid + root * corner;
  return corners;
}

}  // namespace

BodySet::BodySet(const Project& project, const BlockSystem& system)
    : turns_finitely_(project.solver.strain != Strain::incremental &&
                      TimeIntegration::of(project.solver).smooth_fraction() == 1) {
  int tetrahedra = 0;
  for (const Block& block : system.blocks) {
    Body body = make_body(block, project.materials.at(block.material));
    body.first_node = static_cast<int>(nodes.reference.size());
    body.first_tetrahedron = tetrahedra;
    tetrahedra += static_cast<int>(block.mesh.tetrahedra.size());
    nodes.reference.insert(nodes.reference.end(), block.mesh.nodes.begin(), block.mesh.nodes.end());
    nodes.body.resize(nodes.reference.size(), static_cast<int>(bodies.size()));
    bodies.push_back(body);
  }
  nodes.of_blocks = static_cast<int>(nodes.reference.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Block& block = system.blocks[b];
    const int index = static_cast<int>(b);
    bodies[b].first_element = static_cast<int>(elements.size());
    add_tetrahedra(block, index);
    if (bodies[b].kind == BodyKind::affine) add_affine(block, index);
    if (bodies[b].kind == BodyKind::rigid) add_rigid(block, index);
    bodies[b].element_count = static_cast<int>(elements.size()) - bodies[b].first_element;
  }
  for (Element& element : elements) element.number = element_numbers++;
  nodes.position = nodes.reference;
  for (auto* vectors : {&nodes.velocity, &nodes.acceleration, &nodes.prescribed})
    vectors->assign(nodes.reference.size(), Vec3::Zero());
  nodes.dof_block.assign(nodes.reference.size(), -1);
  number_dof_blocks();
  stress.assign(elements.size(), Voigt::Zero());
  shapes.resize(elements.size());
  update_shapes();
}

void BodySet::add_tetrahedra(const Block& block, int index) {
  Body& body = bodies[index];
  for (const auto& tetrahedron : block.mesh.tetrahedra) {
    Element element{};
    Corners corners;
    for (int i = 0; i < 4; ++i) {
      element.nodes[i] = body.first_node + tetrahedron[i];
      corners[i] = nodes.reference[element.nodes[i]];
    }
    const double volume = element_shape(corners).volume;
    if (!(volume > 0)) throw std::invalid_argument("block " + block.name + " has an inverted tetrahedron");
    body.reference_volume += volume;
    element.body = index;
    element.mass = body.density * volume;
    if (body.kind == BodyKind::tetrahedra) elements.push_back(element);
  }
}

int BodySet::add_control_node(const Vec3& where, int body) {
  nodes.reference.push_back(where);
  nodes.body.push_back(body);
  return static_cast<int>(nodes.reference.size()) - 1;
}

void BodySet::add_affine(const Block& block, int index) {
  Body& body = bodies[index];
  const VolumeMoments moments = volume_moments(block.mesh);
  const Corners corners = equivalent_tetrahedron(moments);
  const ElementShape shape = element_shape(corners);
  Element element{};
  for (int i = 0; i < 4; ++i) element.nodes[i] = add_control_node(corners[i], index);
  element.body = index;
  element.mass = body.density * moments.volume;
  element.volume_ratio = moments.volume / shape.volume;
  elements.push_back(element);
  body.first_control_node = element.nodes[0];
  body.first_carried = static_cast<int>(carried.size());
  for (const Vec3& x : block.mesh.nodes) {
    std::array<double, 4> weights;
    for (int i = 0; i < 4; ++i) weights[i] = 0.25 + shape.gradient[i].dot(x - moments.centroid);
    carried.push_back(weights);
  }
}

void BodySet::add_rigid(const Block& block, int index) {
  Body& body = bodies[index];
  const VolumeMoments moments = volume_moments(block.mesh);
  RigidBody one;
  one.body = index;
  one.centre = add_control_node(moments.centroid, index);
  one.mass = body.density * moments.volume;
  one.inertia = one.mass * (moments.spread.trace() * Mat3::Identity() - moments.spread);
  one.radius =
      std::sqrt(Eigen::SelfAdjointEigenSolver<Mat3>(one.inertia, Eigen::EigenvaluesOnly).eigenvalues()[2] / one.mass);
  for (const Vec3& x : block.mesh.nodes) one.reach = std::max(one.reach, (x - moments.centroid).norm());
  body.rigid = static_cast<int>(rigid.size());
  rigid.push_back(one);
}

void BodySet::number_dof_blocks() {
  nodes.movable = 0;
  nodes.free.clear();
  moving.clear();
  turning.clear();
  const auto let_go = [&](int node) {
    nodes.dof_block[node] = nodes.movable++;
    nodes.free.push_back(node);
  };
  std::fill(nodes.dof_block.begin(), nodes.dof_block.end(), -1);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Body& body = bodies[b];
    if (body.rigid >= 0) rigid[body.rigid].rotation_dof_block = -1;
    if (body.fixed) continue;
    moving.push_back(static_cast<int>(b));
    if (body.kind == BodyKind::tetrahedra)
      for (int n = body.first_node; n < body.first_node + body.node_count; ++n) let_go(n);
    if (body.kind == BodyKind::affine)
      for (int c = 0; c < 4; ++c) let_go(body.first_control_node + c);
    if (body.kind != BodyKind::rigid) continue;
    let_go(rigid[body.rigid].centre);
    rigid[body.rigid].rotation_dof_block = nodes.movable++;
    turning.push_back(body.rigid);
  }
  linear.clear();
  neo_hookean.clear();
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (int i = 0; i < 4; ++i) elements[e].dof_blocks[i] = nodes.dof_block[elements[e].nodes[i]];
    (bodies[elements[e].body].law == MaterialLaw::linear ? linear : neo_hookean).push_back(static_cast<int>(e));
  }
}

void BodySet::hold(const std::vector<bool>& held) {
  std::vector<HeldElement> all = std::move(held_);
  held_.clear();
  for (std::size_t e = 0; e < elements.size(); ++e) all.push_back({elements[e], shapes[e], stress[e]});
  std::stable_sort(all.begin(), all.end(),
                   [](const HeldElement& a, const HeldElement& b) { return a.element.body < b.element.body; });
  elements.clear();
  shapes.clear();
  stress.clear();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    bodies[b].fixed = bodies[b].built_fixed() || held[b];
    bodies[b].element_count = 0;
  }
  for (std::size_t n = 0; n < nodes.velocity.size(); ++n)
    if (bodies[nodes.body[n]].fixed) nodes.velocity[n] = nodes.acceleration[n] = Vec3::Zero();
  for (RigidBody& one : rigid)
    if (bodies[one.body].fixed) one.angular_momentum = one.moment = Vec3::Zero();
  for (const HeldElement& one : all) {
    Body& body = bodies[one.element.body];
    if (body.fixed) {
      held_.push_back(one);
      continue;
    }
    if (body.element_count++ == 0) body.first_element = static_cast<int>(elements.size());
    elements.push_back(one.element);
    shapes.push_back(one.shape);
    stress.push_back(one.stress);
  }
  number_dof_blocks();
}

std::span<const BodySet::HeldElement> BodySet::held_of(int index) const {
  const auto begin = std::partition_point(held_.begin(), held_.end(),
                                          [&](const HeldElement& one) { return one.element.body < index; });
  const auto end =
      std::partition_point(begin, held_.end(), [&](const HeldElement& one) { return one.element.body == index; });
  return {begin, end};
}

std::vector<Voigt> BodySet::stress_of_held(int index) const {
  std::vector<Voigt> kept;
  for (const HeldElement& one : held_of(index)) kept.push_back(one.stress);
  return kept;
}

std::vector<Element> BodySet::elements_of(int index) const {
  const auto first = elements.begin() + bodies[index].first_element;
  if (!bodies[index].fixed) return {first, first + bodies[index].element_count};
  std::vector<Element> kept;
  for (const HeldElement& one : held_of(index)) kept.push_back(one.element);
  return kept;
}

ElementShape BodySet::shape_of(const Element& element) const {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners[i] = nodes.position[element.nodes[i]];
  ElementShape shape = element_shape(corners);
  shape.volume *= element.volume_ratio;
  return shape;
}

bool BodySet::any_moves_by_elements(std::span<const int> some) const {
  return std::ranges::any_of(some, [&](int b) { return !bodies[b].fixed && !bodies[b].single_body(); });
}

void BodySet::update_shapes() {
  for (std::size_t e = 0; e < elements.size(); ++e) shapes[e] = shape_of(elements[e]);
}

void BodySet::add_couplings(std::vector<std::pair<int, int>>& couplings) const {
  for (const Element& element : elements)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b) couplings.emplace_back(element.dof_blocks[a], element.dof_blocks[b]);
  for (const int r : turning) couplings.emplace_back(nodes.dof_block[rigid[r].centre], rigid[r].rotation_dof_block);
}

void BodySet::join_dof_blocks(DisjointSets& together) const {
  for (const int b : moving) {
    const Body& body = bodies[b];
    if (body.rigid >= 0) {
      together.join(nodes.dof_block[rigid[body.rigid].centre], rigid[body.rigid].rotation_dof_block);
      continue;
    }
    const int first = nodes.dof_block[body.first_free()];
    for (int i = 1; i < body.free_count(); ++i) together.join(first, nodes.dof_block[body.first_free() + i]);
  }
}

Corners BodySet::corner_increments(const Element& element, const Increment& d) const {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners[i] = d.segment<3>(3 * element.dof_blocks[i]);
  return corners;
}

Vec3 BodySet::node_increment(int node, const Increment& d) const {
  if (const int dof_block = nodes.dof_block[node]; dof_block >= 0) return d.segment<3>(3 * dof_block);
  const Body& body = bodies[nodes.body[node]];
  if (body.fixed) return nodes.prescribed[node];
  if (body.kind == BodyKind::affine) {
    Vec3 sum = Vec3::Zero();
    for (int c = 0; c < 4; ++c)
      sum += carried[node - body.first_node + body.first_carried][c] *
             d.segment<3>(3 * nodes.dof_block[body.first_control_node + c]);
    return sum;
  }
  const RigidBody& one = rigid[body.rigid];
  return Vec3(d.segment<3>(3 * nodes.dof_block[one.centre])) +
         turn_of(one.theta(d), nodes.position[node] - nodes.position[one.centre]);
}

void BodySet::positions_after(const Increment& d, std::vector<Vec3>& x) const {
  x = nodes.position;
  const auto place = [&](std::span<const int> some) {
    for (const int b : some)
      for (int n = bodies[b].first_node; n < bodies[b].first_node + bodies[b].node_count; ++n)
        x[n] += node_increment(n, d);
  };
  const auto place_some = [&](int first, int last) { place(std::span(moving).subspan(first, last - first)); };
  in_parallel(static_cast<int>(moving.size()), bodies_worth_a_thread, std::ref(place_some));
  place(driven);
}

void BodySet::dof_blocks_of(int node, std::vector<int>& dof_blocks) const {
  dof_blocks.clear();
  const Body& body = bodies[nodes.body[node]];
  if (body.fixed) return;
  if (body.kind == BodyKind::tetrahedra) dof_blocks.push_back(nodes.dof_block[node]);
  if (body.kind == BodyKind::affine)
    for (int c = 0; c < 4; ++c) dof_blocks.push_back(nodes.dof_block[body.first_control_node + c]);
  if (body.kind != BodyKind::rigid) return;
  dof_blocks.push_back(nodes.dof_block[rigid[body.rigid].centre]);
  dof_blocks.push_back(rigid[body.rigid].rotation_dof_block);
}

void BodySet::advance(const Increment& from, const Eigen::VectorXd& change, Increment& to) const {
  to = from + change;
  for (const int r : turning) {
    const int first = 3 * rigid[r].rotation_dof_block;
    if (change.segment<3>(first).isZero(0)) continue;
    const double radius = rigid[r].radius;
    to.segment<3>(first) = radius * composed(change.segment<3>(first) / radius, from.segment<3>(first) / radius);
  }
  if (!turns_finitely_) return;
  for (const int b : moving)
    if (bodies[b].kind != BodyKind::rigid) turn_on(*this, bodies[b], from, change, to);
}

void BodySet::carry_positions(Body& body) {
  double square = 0;
  for (int n = 0; n < body.node_count; ++n) {
    Vec3 x = Vec3::Zero();
    if (body.kind == BodyKind::affine) {
      for (int c = 0; c < 4; ++c) x += carried[body.first_carried + n][c] * nodes.position[body.first_control_node + c];
    } else {
      const RigidBody& one = rigid[body.rigid];
      const Vec3 arm = nodes.reference[body.first_node + n] - nodes.reference[one.centre];
      x = nodes.position[one.centre] + one.rotation * arm;
    }
    Vec3& before = nodes.position[body.first_node + n];
    square = std::max(square, (x - before).squaredNorm());
    before = x;
  }
  body.largest_displacement = std::sqrt(square);
}

void BodySet::move(const Increment& d) {
  for (const int b : driven) {
    Body& body = bodies[b];
    for (int n = body.first_node; n < body.first_node + body.node_count; ++n) nodes.position[n] += nodes.prescribed[n];
    body.largest_displacement = nodes.prescribed[body.first_node].norm();
  }
  for (const int b : moving) bodies[b].largest_displacement = 0;
  for (const int n : nodes.free) {
    const Vec3 step = d.segment<3>(3 * nodes.dof_block[n]);
    Body& body = bodies[nodes.body[n]];
    nodes.position[n] += step;
    body.largest_displacement = std::max(body.largest_displacement, step.norm());
  }
  for (const int r : turning) {
    RigidBody& one = rigid[r];
    const Mat3 turn = rotation_by(one.theta(d));
    one.rotation = Eigen::Quaterniond(turn * one.rotation).normalized().toRotationMatrix();
  }
  for (const int b : moving)
    if (bodies[b].single_body()) carry_positions(bodies[b]);
}

void BodySet::carry_velocities() {
  for (const int b : moving) {
    const Body& body = bodies[b];
    if (!body.single_body()) continue;
    const RigidBody* one = body.kind == BodyKind::rigid ? &rigid[body.rigid] : nullptr;
    const Vec3 spin = one ? one->spin() : Vec3::Zero();
    for (int n = 0; n < body.node_count; ++n) {
      Vec3& v = nodes.velocity[body.first_node + n];
      v.setZero();
      if (one)
        v = nodes.velocity[one->centre] + spin.cross(nodes.position[body.first_node + n] - nodes.position[one->centre]);
      else
        for (int c = 0; c < 4; ++c)
          v += carried[body.first_carried + n][c] * nodes.velocity[body.first_control_node + c];
    }
  }
}

int BodySet::node_of(int dof_block) const {
  const auto turns =
      std::find_if(turning.begin(), turning.end(), [&](int r) { return rigid[r].rotation_dof_block == dof_block; });
  if (turns != turning.end()) return rigid[*turns].centre;
  return *std::find_if(nodes.free.begin(), nodes.free.end(), [&](int n) { return nodes.dof_block[n] == dof_block; });
}

void BodySet::give_accelerations(const Eigen::VectorXd& accelerations) {
  for (const int n : nodes.free) nodes.acceleration[n] = accelerations.segment<3>(3 * nodes.dof_block[n]);
  for (const int r : turning) rigid[r].moment = rigid[r].inertia_now() * rigid[r].theta(accelerations);
}

void BodySet::scale_acceleration(int body, double factor) {
  const Body& scaled = bodies[body];
  if (scaled.rigid >= 0) {
    nodes.acceleration[rigid[scaled.rigid].centre] *= factor;
    rigid[scaled.rigid].moment *= factor;
    return;
  }
  for (int n = scaled.first_free(); n < scaled.first_free() + scaled.free_count(); ++n) nodes.acceleration[n] *= factor;
}

double BodySet::top_speed(std::span<const char> left_out) const {
  const auto counts = [&](int body) { return left_out.empty() || !left_out[body]; };
  double square = 0;
  for (const int n : nodes.free)
    if (counts(nodes.body[n])) square = std::max(square, nodes.velocity[n].squaredNorm());
  for (const int b : driven) square = std::max(square, nodes.velocity[bodies[b].first_node].squaredNorm());
  double speed = std::sqrt(square);
  for (const int r : turning)
    if (counts(rigid[r].body))
      speed = std::max(speed, nodes.velocity[rigid[r].centre].norm() + rigid[r].reach * rigid[r].spin().norm());
  return speed;
}

void BodySet::find_ways(double time, std::span<const char> left_out, std::vector<BodyWay>& ways) const {
  ways.assign(bodies.size(), {});
  for (const int b : driven) ways[b].mean = nodes.prescribed[bodies[b].first_node];
  for (const int b : moving) {
    if (!left_out.empty() && left_out[b]) continue;
    const auto motion = [&](int node) -> Vec3 { return time * nodes.velocity[node]; };
    ways[b] = way_of(bodies[b].first_node, bodies[b].node_count, motion);
  }
}

}  // namespace talus
