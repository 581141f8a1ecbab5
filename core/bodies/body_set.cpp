#include "bodies/body_set.hpp"

#include <stdexcept>

namespace talus {

namespace {

Body make_body(const Block& block, const Material& material) {
  Body body;
  body.node_count = static_cast<int>(block.mesh.nodes.size());
  body.fixed = block.body == BodyKind::fixed;
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
    for (const Vec3& point : block.mesh.nodes) {
      nodes.reference.push_back(point);
      nodes.freedom.push_back(body.fixed ? -1 : nodes.movable++);
    }
    for (const auto& tetrahedron : block.mesh.tetrahedra) {
      Element element;
      Corners corners;
      for (int i = 0; i < 4; ++i) {
        element.nodes[i] = body.first_node + tetrahedron[i];
        element.freedoms[i] = nodes.freedom[element.nodes[i]];
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
  nodes.velocity.assign(nodes.reference.size(), Vec3::Zero());
  stress.assign(elements.size(), Voigt::Zero());
  shapes.resize(elements.size());
  update_shapes();
}

void BodySet::update_shapes() {
  for (std::size_t e = 0; e < elements.size(); ++e) {
    Corners corners;
    for (int i = 0; i < 4; ++i) corners[i] = nodes.position[elements[e].nodes[i]];
    shapes[e] = element_shape(corners);
  }
}

Corners BodySet::corner_increments(const Element& element, const Increment& d) const {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners[i] = d.segment<3>(3 * element.freedoms[i]);
  return corners;
}

}  // namespace talus
