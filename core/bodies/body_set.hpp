#pragma once

#include <utility>
#include <vector>

#include "bodies/strain.hpp"
#include "mesh/block.hpp"

namespace talus {

/// All nodes of all blocks, in BlockSystem's order. A node of a fixed block has no freedom (−1).
struct NodeSet {
  std::vector<Vec3> reference;     ///< m, at the start of the run
  std::vector<Vec3> position;      ///< m, at the start of the step
  std::vector<Vec3> velocity;      ///< m/s, at the start of the step
  std::vector<Vec3> acceleration;  ///< m/s², at the start of the step
  std::vector<Vec3> prescribed;    ///< m, increment in this step of a node without freedom; zero for all others
  std::vector<int> freedom;        ///< number among the movable nodes; its unknowns are 3·freedom … 3·freedom+2
  int movable = 0;
  bool any_prescribed = false;  ///< some node without freedom moves in this step
};

/// A four-node tetrahedron of a movable block.
struct Element {
  std::array<int, 4> nodes;  ///< into NodeSet
  std::array<int, 4> freedoms;
  int body = 0;
  double mass = 0;  ///< kg, constant whatever the strain does
};

/// A block as the solver moves it.
struct Body {
  int first_node = 0, node_count = 0;
  int first_element = 0, element_count = 0;  ///< into BodySet::elements; none while fixed
  int first_tetrahedron = 0;                 ///< into a frame's stress
  bool built_fixed = false;                  ///< never moves by itself
  bool fixed = false;                        ///< now: built so, or held by a stage
  double density = 0;                        ///< kg/m³
  double young = 0;                          ///< Pa
  Elastic elastic;
  double reference_volume = 0;  ///< m³, of the mesh
};

/// Displacement increments of a step [m]: 3 numbers a movable node.
using Increment = Eigen::VectorXd;

/// All blocks with their nodes, elements and stresses: what moves. Elements run through the bodies that may move now.
struct BodySet {
  NodeSet nodes;
  std::vector<Body> bodies;
  std::vector<Element> elements;
  std::vector<ElementShape>
      shapes;                 ///< an element: before the run, or at the start of the step if update_shapes says so
  std::vector<Voigt> stress;  ///< Pa, an element: what the paper's incremental strain has summed up

  BodySet(const Project& project, const BlockSystem& system);

  int unknowns() const { return 3 * nodes.movable; }
  /// Shapes at the current positions: incremental strain calls for it at the start of every step.
  void update_shapes();
  /// Holds or lets go bodies that were built to move, one flag a body; held ones stand still and keep their stress.
  void hold(const std::vector<bool>& held);
  /// Adds the pairs of movable nodes that an element joins.
  void add_couplings(std::vector<std::pair<int, int>>& couplings) const;
  Corners corner_increments(const Element& element, const Increment& d) const;
  Vec3 node_increment(int node, const Increment& d) const {
    const int freedom = nodes.freedom[node];
    return freedom < 0 ? nodes.prescribed[node] : Vec3(d.segment<3>(3 * freedom));
  }
  /// Stress of the tetrahedra of a body that is held, in their order [Pa]; none where it was built fixed.
  std::vector<Voigt> stress_of_held(int body) const;

 private:
  struct HeldElement {
    Element element;
    ElementShape shape;
    Voigt stress;
  };
  void number_freedoms();
  std::vector<HeldElement> held_;  ///< of bodies that a stage holds, in their order
};

}  // namespace talus
