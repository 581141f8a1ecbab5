#include "bodies/body_set.hpp"

#include <algorithm>
#include <stdexcept>

namespace talus {

namespace {

Body make_body(const Block& block, const Material& material) {
  Body body;
  body.node_count = static_cast<int>(block.mesh.nodes.size());
  body.built_fixed = body.fixed = block.body == BodyKind::fixed;
  body.density = material.density;
  body.young = material.young;
  body.elastic = Elastic::of(material);
  return body;
}

}  // namespace

BodySet::BodySet(const Project& project, const BlockSystem& system) {
  int tetrahedra = 0;
  for (const Block& block : system.blocks) {
    Body body = make_body(block, project.materials.at(block.material));
    body.first_node = static_cast<int>(nodes.reference.size());
    body.first_tetrahedron = tetrahedra;
    body.first_element = static_cast<int>(elements.size());
    tetrahedra += static_cast<int>(block.mesh.tetrahedra.size());
    nodes.reference.insert(nodes.reference.end(), block.mesh.nodes.begin(), block.mesh.nodes.end());
    for (const auto& tetrahedron : block.mesh.tetrahedra) {
      Element element;
      Corners corners;
      for (int i = 0; i < 4; ++i) {
        element.nodes[i] = body.first_node + tetrahedron[i];
        corners[i] = nodes.reference[element.nodes[i]];
      }
      const double volume = element_shape(corners).volume;
      if (!(volume > 0)) throw std::invalid_argument("block " + block.name + " has an inverted tetrahedron");
      body.reference_volume += volume;
      if (body.fixed) continue;
      element.body = static_cast<int>(bodies.size());
      element.mass = body.density * volume;
      elements.push_back(element);
    }
    body.element_count = static_cast<int>(elements.size()) - body.first_element;
    bodies.push_back(body);
  }
  nodes.position = nodes.reference;
  for (auto* vectors : {&nodes.velocity, &nodes.acceleration, &nodes.prescribed})
    vectors->assign(nodes.reference.size(), Vec3::Zero());
  nodes.freedom.resize(nodes.reference.size());
  number_freedoms();
  stress.assign(elements.size(), Voigt::Zero());
  shapes.resize(elements.size());
  update_shapes();
}

void BodySet::number_freedoms() {
  nodes.movable = 0;
  for (const Body& body : bodies)
    for (int n = body.first_node; n < body.first_node + body.node_count; ++n)
      nodes.freedom[n] = body.fixed ? -1 : nodes.movable++;
  for (Element& element : elements)
    for (int i = 0; i < 4; ++i) element.freedoms[i] = nodes.freedom[element.nodes[i]];
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
    Body& body = bodies[b];
    body.fixed = body.built_fixed || held[b];
    body.element_count = 0;
    for (int n = body.first_node; body.fixed && n < body.first_node + body.node_count; ++n)
      nodes.velocity[n] = nodes.acceleration[n] = Vec3::Zero();
  }
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
  number_freedoms();
}

std::vector<Voigt> BodySet::stress_of_held(int index) const {
  std::vector<Voigt> kept;
  for (const HeldElement& one : held_)
    if (one.element.body == index) kept.push_back(one.stress);
  return kept;
}

void BodySet::update_shapes() {
  for (std::size_t e = 0; e < elements.size(); ++e) {
    Corners corners;
    for (int i = 0; i < 4; ++i) corners[i] = nodes.position[elements[e].nodes[i]];
    shapes[e] = element_shape(corners);
  }
}

void BodySet::add_couplings(std::vector<std::pair<int, int>>& couplings) const {
  for (const Element& element : elements)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b) couplings.emplace_back(element.freedoms[a], element.freedoms[b]);
}

Corners BodySet::corner_increments(const Element& element, const Increment& d) const {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners[i] = d.segment<3>(3 * element.freedoms[i]);
  return corners;
}

}  // namespace talus
