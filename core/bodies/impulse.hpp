#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "bodies/body_set.hpp"

/// Impulses: how they change velocities in no time.
namespace talus {

/// Inverse mass matrices of bodies that deform, each for its own nodes or control nodes; made when first needed. Mass
/// stays the same whatever bodies do.
class InverseMasses {
 public:
  explicit InverseMasses(const BodySet& set);
  ~InverseMasses();
  InverseMasses(const InverseMasses&) = delete;
  InverseMasses& operator=(const InverseMasses&) = delete;

  /// Several threads may then ask for velocities of this body.
  void make(int body);
  /// Velocities of the nodes of a body [m/s] by impulses on them [N s], both one number a node or control node: all
  /// three directions are alike. The body moves now.
  Eigen::VectorXd velocities(int body, const Eigen::VectorXd& impulses);

 private:
  struct Factor;
  const BodySet& set_;
  std::vector<std::unique_ptr<Factor>> factors_;  ///< a body
};

/// How fast Σ weight·node moves [m/s], in a step of this length [s]: nodes of fixed bodies as they are prescribed to.
Vec3 velocity_of(const BodySet& set, std::span<const int> nodes, std::span<const double> weights, double step);

/// Σ weight·node of nodes of one or two bodies, as impulses move it: a contact point, the first body against the
/// second.
class StruckPoint {
 public:
  StruckPoint() = default;
  StruckPoint(const BodySet& set, InverseMasses& masses, std::span<const int> nodes, std::span<const double> weights,
              double step);

  Vec3 velocity(const BodySet& set) const;               ///< m/s
  const Vec3& driven() const { return driven_; }         ///< m/s, of it what bodies that are moved by prescription do
  const Mat3& mobility() const { return mobility_; }     ///< 1/kg: velocity by an impulse of one
  void strike(BodySet& set, const Vec3& impulse) const;  ///< changes velocities and angular momenta [N s]

 private:
  struct Deforming {
    int first_node;
    Eigen::VectorXd weights, response;  // 1; 1/kg
  };
  struct Turning {
    int rigid, centre;
    double weight;
    double response;       // 1/kg, of the centroid
    Vec3 arm;              // m, times the weights
    Mat3 inverse_inertia;  // 1/(kg m²)
  };
  std::span<const Turning> turning() const { return std::span(turning_).first(turning_count_); }
  /// Two rigid bodies strike each other at one place, the point of the first or second of them.
  void meet(const BodySet& set, int carrier);
  void add(const BodySet& set, InverseMasses& masses, int body, std::span<const int> nodes,
           std::span<const double> weights);

  std::vector<Deforming> deforming_;
  std::array<Turning, 2> turning_;
  int turning_count_ = 0;
  Vec3 driven_ = Vec3::Zero();  // m/s, part of bodies that are moved by prescription
  Mat3 mobility_ = Mat3::Zero();
};

}  // namespace talus
