#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// What a contact does in the current iterate: no force; sheared below its strength; sliding at its strength.
enum class ContactMode : std::uint8_t { open, stick, slip };

/// Strength and stiffness of a joint as contact law sees it, SI, angles already turned into coefficients.
struct JointLaw {
  double friction = 0;                  ///< tan φ
  double residual_friction = 0;         ///< tan φ once a bond is broken
  double cohesion = 0;                  ///< Pa
  double tensile_strength = 0;          ///< Pa
  double normal_stiffness = 0;          ///< Pa/m; 0: automatic
  double shear_stiffness = 0;           ///< Pa/m; 0: automatic
  std::optional<double> restitution{};  ///< speed after an impact over that before; absent: as springs do
};

/// One pair of touching points P1 (first body) and P2 (second body), eq. (29). Fixed during a step.
/// The gap is `gap + normal·u` with the relative displacement u = Σ weight·D over the stencil (first minus second body;
/// nodes of fixed bodies included: their D is zero). A negative gap is penetration: d_n of the paper is −gap.
struct ContactPoint {
  std::uint64_t key = 0;  ///< names the pair of features; the same contact has the same key in the next step
  int bodies[2]{};
  int smooth_faces[2]{};                ///< of both surfaces, on which it lies (−1 at a sharp edge)
  int joint = 0;                        ///< index into the joint laws
  Vec3 position = Vec3::Zero();         ///< m, on the first body
  Vec3 normal = Vec3::Zero();           ///< unit, from the second body to the first
  double gap = 0;                       ///< m, at the start of the step
  double initial_interference = 0;      ///< m, penetration in which the contact was found first: `gap` leaves it out
  double size = 0;                      ///< m, local mesh size: what lengths are measured against
  double area = 0;                      ///< m², its part of the contact area; 0 where a vertex or an edge touches
  double normal_stiffness = 0;          ///< N/m
  double shear_stiffness = 0;           ///< N/m
  double penalty_scaling = 1;           ///< of both stiffnesses, by what the step can follow or by what sinks too deep
  std::optional<double> restitution{};  ///< of the joint
  double friction = 0;                  ///< tan φ that holds now (residual once broken)
  double cohesion = 0;                  ///< N, c·A while bonded, else 0
  double tension = 0;                   ///< N, σ_t·A while bonded, else 0
  bool bonded = false;
  bool broken = false;              ///< a bond of the faces that it lies between has broken
  bool is_new = true;               ///< goes on from no former contact
  bool stiffened = false;           ///< its spring was made stiffer in this step, as it went too deep
  bool let_go = false;              ///< it stopped a landing, and pushes nothing out from the end of the step on
  Vec3 shear_start = Vec3::Zero();  ///< N, shear force on the first body at the start of the step, in the contact plane
  double slip_start = 0;            ///< m, path slipped so far
  double multiplier = 0;            ///< N, compression carried without penetration at the start of the step
  int stencil_begin = 0, stencil_end = 0;  ///< range in ContactSet's nodes and weights
  // Of the current iterate; begins as what it was at the end of the last step.
  ContactMode mode = ContactMode::open;

  void archive(auto& state) {
    state(key, bodies, smooth_faces, joint, position, normal, gap, initial_interference, size, area);
    state(normal_stiffness, shear_stiffness, penalty_scaling, restitution, friction, cohesion, tension, bonded, broken);
    state(is_new, stiffened, let_go, shear_start, slip_start, multiplier, stencil_begin, stencil_end, mode);
  }
};

/// The order of contact points: those of two bodies together, and of these those that one carries; then by key.
bool comes_before(const ContactPoint& p, const ContactPoint& q);

inline std::pair<int, int> bodies_of(const ContactPoint& point) { return {point.bodies[0], point.bodies[1]}; }

/// All contact points of a step, and lists of them by what their law calls for.
struct ContactSet {
  std::vector<ContactPoint> points;  ///< of detect() in the order of comes_before
  std::vector<int> nodes;            ///< global node numbers of all stencils
  std::vector<double> weights;       ///< Σ = +1 over the first body's nodes, −1 over the second's

  std::vector<int> loose;    ///< numbers of the points without a bond, ascending
  std::vector<int> bonded;   ///< … of those with one
  std::vector<int> sheared;  ///< … of those that can carry shear: with friction, or with cohesion of a bond
  std::vector<int> by_key;   ///< the numbers of all, by ascending keys

  struct Stencil {
    std::span<const int> nodes;
    std::span<const double> weights;
  };
  Stencil stencil(const ContactPoint& point) const {
    const auto count = static_cast<std::size_t>(point.stencil_end - point.stencil_begin);
    return {std::span(nodes).subspan(point.stencil_begin, count),
            std::span(weights).subspan(point.stencil_begin, count)};
  }

  void clear();
  /// Fills the lists from the points. For what detect() gives this has been done.
  void sort_out();

  void archive(auto& state) {
    state(points, nodes, weights);
    if (state.reads()) sort_out();
  }
};

/// What is remembered of a contact of two bodies at rest, as it was in the last step that they took part in.
struct RestingContact {
  int bodies[2];
  int joint;
  Vec3 position;  ///< m
  Vec3 normal;    ///< unit, from the second body to the first
  ContactMode mode;
  double normal_force;  ///< N, compression positive
  Vec3 shear_force;     ///< N, on the first body
  double area;          ///< m²
  double friction;      ///< tan φ
  double cohesion;      ///< N, c·A while bonded, else 0
  bool bonded, broken;  ///< as ContactPoint's
};

/// What a contact point came to at the end of an accepted step; handed back to the memory.
struct ContactOutcome {
  double normal_force = 0;          ///< N, compression positive
  Vec3 shear_force = Vec3::Zero();  ///< N, on the first body
  double gap = 0;                   ///< m, at the end
  double slip = 0;                  ///< m, path slipped in this step
  bool broke = false;               ///< its bond broke in this step
  double multiplier = 0;            ///< N, as ContactPoint's, to go on with
};

}  // namespace talus
