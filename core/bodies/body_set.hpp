#pragma once

#include <span>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "bodies/body_way.hpp"
#include "bodies/rigid_body.hpp"
#include "bodies/strain.hpp"
#include "mesh/block.hpp"

namespace talus {

/// All nodes of all blocks, in BlockSystem's order, and behind them the control nodes: four corners of each affine
/// body, the centroid of each rigid one. Nodes of those blocks follow their control nodes and have no degree-of-freedom
/// block of their own (−1); nor has a node of a body that is fixed. A degree-of-freedom block is three unknowns.
struct NodeSet {
  std::vector<Vec3> reference;     ///< m, at the start of the run
  std::vector<Vec3> position;      ///< m, at the start of the step
  std::vector<Vec3> velocity;      ///< m/s, at the start of the step
  std::vector<Vec3> acceleration;  ///< m/s², at the start of the step; of nodes that have unknowns
  std::vector<Vec3> prescribed;    ///< m, increment in this step of a node of a fixed body; zero for all others
  std::vector<int> dof_block;      ///< number k of a node's own; its unknowns are 3k … 3k+2
  std::vector<int> body;           ///< that it belongs to
  std::vector<int> free;           ///< nodes that have one of their own, in its order
  int of_blocks = 0;               ///< the first so many are nodes of blocks
  int movable = 0;                 ///< degree-of-freedom blocks, those of nodes and of the rotations of rigid bodies
  bool any_prescribed = false;     ///< some node of a fixed body moves in this step
};

/// A four-node tetrahedron of a movable block; or all of an affine block, as the tetrahedron of its control nodes,
/// which is made such that its consistent mass is the block's.
struct Element {
  std::array<int, 4> nodes;  ///< into NodeSet
  std::array<int, 4> dof_blocks;
  int body = 0;
  int number = 0;           ///< among all elements, those of held bodies too
  double mass = 0;          ///< kg, constant whatever the strain does
  double volume_ratio = 1;  ///< volume that it stands for, over its own
};

/// A block as the solver moves it.
struct Body {
  BodyKind kind = BodyKind::tetrahedra;  ///< as it was built
  int first_node = 0, node_count = 0;
  int first_element = 0, element_count = 0;        ///< into BodySet::elements; none while fixed, none if rigid
  int first_tetrahedron = 0;                       ///< into a frame's stress
  int first_control_node = -1, first_carried = 0;  ///< of an affine body, into NodeSet and BodySet::carried
  int rigid = -1;                                  ///< of a rigid body, into BodySet::rigid
  bool fixed = false;                              ///< now: built so, or held
  double density = 0;                              ///< kg/m³
  double young = 0;                                ///< Pa
  Elastic elastic;
  MaterialLaw law = MaterialLaw::linear;
  double reference_volume = 0;         ///< m³, of the mesh
  double largest_displacement = 0;     ///< m, of a node, when the body moved last
  bool constant_acceleration = false;  ///< it begins this step with the acceleration that it ends with

  /// What changes from step to step, beside who is held.
  void archive(auto& state) { state(largest_displacement, constant_acceleration); }

  double mass() const { return density * reference_volume; }  ///< kg
  bool built_fixed() const { return kind == BodyKind::fixed; }
  bool single_body() const { return kind == BodyKind::rigid || kind == BodyKind::affine; }
  /// Nodes whose motion is that of a body that is not rigid: the four control nodes of an affine one, else all.
  int first_free() const { return kind == BodyKind::affine ? first_control_node : first_node; }
  int free_count() const { return kind == BodyKind::affine ? 4 : node_count; }
};

/// Increments of a step [m]: three numbers a degree-of-freedom block.
using Increment = Eigen::VectorXd;

/// All blocks with their nodes, elements and stresses: what moves. Elements run through the bodies that may move now.
struct BodySet {
  NodeSet nodes;
  std::vector<Body> bodies;
  int element_numbers = 0;
  std::vector<int> moving;  ///< bodies that are not fixed now
  std::vector<int> driven;  ///< fixed bodies that are moved by prescription in this stage
  std::vector<Element> elements;
  std::vector<int> linear, neo_hookean;  ///< numbers of the elements whose rock has this law, ascending
  std::vector<ElementShape>
      shapes;                 ///< an element: before the run, or at the start of the step if update_shapes says so
  std::vector<Voigt> stress;  ///< Pa, an element: what the paper's incremental strain has summed up
  std::vector<RigidBody> rigid;
  std::vector<int> turning;                    ///< rigid bodies that are not fixed now
  std::vector<std::array<double, 4>> carried;  ///< a node of an affine body: weights of its four control nodes

  BodySet(const Project& project, const BlockSystem& system);

  int unknowns() const { return 3 * nodes.movable; }
  /// Whether one of these bodies moves and has elements.
  bool any_moves_by_elements(std::span<const int> some) const;
  /// Shapes at the current positions: incremental strain calls for it at the start of every step.
  void update_shapes();
  /// Holds or lets go bodies that were built to move, one flag a body; held ones stand still and keep their stress.
  void hold(const std::vector<bool>& held);
  /// Adds the pairs of degree-of-freedom blocks that the mass and the stiffness of a body join.
  void add_couplings(std::vector<std::pair<int, int>>& couplings) const;
  /// The degree-of-freedom blocks of each body belong together.
  void join_dof_blocks(DisjointSets& together) const;
  Corners corner_increments(const Element& element, const Increment& d) const;
  Vec3 node_increment(int node, const Increment& d) const;
  /// `x` = where all nodes are once the step is taken [m], on several cores.
  void positions_after(const Increment& d, std::vector<Vec3>& x) const;
  /// Degree-of-freedom blocks that move a node: its own, or those of its affine or rigid body; none where it is fixed.
  void dof_blocks_of(int node, std::vector<int>& dof_blocks) const;

  /// `to` = the increment that `from` becomes by a further `change`. Unknowns add up, but for rotations, which follow
  /// one another: a change of a rotation turns the body on from where it stands. So do changes that turn a body which
  /// deforms (turn_on), where a step's strains are those of its end and do not feel a rotation.
  void advance(const Increment& from, const Eigen::VectorXd& change, Increment& to) const;
  /// The step is taken: positions and rotations move on by `d`, and the nodes of affine and rigid bodies follow. Each
  /// body notes its largest displacement.
  void move(const Increment& d);
  /// Velocities of the nodes of affine and rigid bodies from those of their control nodes and their angular momentum.
  void carry_velocities();
  /// The node that a degree-of-freedom block moves, or that of the centroid that it turns a body about.
  int node_of(int dof_block) const;
  /// Takes over accelerations [m/s²], three numbers a degree-of-freedom block.
  void give_accelerations(const Eigen::VectorXd& accelerations);
  /// Multiplies the accelerations of a body that moves, and its moment, by `factor`.
  void scale_acceleration(int body, double factor);
  /// The ways of all bodies in some `time` [s] at the speeds that they have, and those of prescribed motion. Bodies
  /// that are `left_out`, a flag each, and fixed ones stay.
  void find_ways(double time, std::span<const char> left_out, std::vector<BodyWay>& ways) const;
  /// No node moves faster than this [m/s]. Bodies that are `left_out`, a flag each, do not count.
  double top_speed(std::span<const char> left_out = {}) const;

  /// What changes from step to step, of bodies of which the same are held.
  void archive(auto& state) {
    state(nodes.position, nodes.velocity, nodes.acceleration, nodes.prescribed, nodes.any_prescribed);
    state(bodies, shapes, stress, rigid, held_);
  }

  /// Stress of the tetrahedra of a body that is held, in their order [Pa]; none where it was built fixed.
  std::vector<Voigt> stress_of_held(int body) const;
  /// The elements of a body that was built to deform, also while it is held.
  std::vector<Element> elements_of(int body) const;

 private:
  struct HeldElement {
    Element element;
    ElementShape shape;
    Voigt stress;

    void archive(auto& state) { state(shape, stress); }
  };
  std::span<const HeldElement> held_of(int body) const;
  void add_tetrahedra(const Block& block, int index);
  void add_affine(const Block& block, int index);
  void add_rigid(const Block& block, int index);
  int add_control_node(const Vec3& where, int body);
  void number_dof_blocks();
  void carry_positions(Body& body);
  ElementShape shape_of(const Element& element) const;
  bool turns_finitely_;            ///< strains are those of the end of a step, and do not feel a rotation
  std::vector<HeldElement> held_;  ///< of bodies that are held, in their order
};

}  // namespace talus
