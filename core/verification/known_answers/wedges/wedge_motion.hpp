#pragma once

#include <optional>

#include "verification/known_answers/wedges/wedge_equilibrium.hpp"
#include "verification/known_answers/wedges/wedge_in_mould.hpp"

namespace talus {

/// What a wedge was seen to do.
struct WedgeMotion {
  std::optional<WedgeMode> mode = WedgeMode::stable;  ///< empty: the run came to no answer
  Vec3 direction = Vec3::Zero();                      ///< unit, of its centroid; zero where stable
  double travel = 0;                                  ///< of its centroid, in lengths of the wedge
  double turn = 0;                                    ///< rad, over the displacement that gives the direction
  double stray = 0;  ///< share of the normal force, over that displacement, that acts on neither plane
  int steps = 0, iterations = 0;
};

/// As `to_string` has it, or "no answer".
constexpr std::string_view mode_text(std::optional<WedgeMode> mode) { return mode ? to_string(*mode) : "no answer"; }

/// Watches the wedge of a scene made by wedge_in_mould. Mode and direction are those of its displacement from 5 % to 10
/// % of its length: before, contacts still deform.
class WedgeWatch {
 public:
  /// `planes` as they lie in the scene, `length` of the wedge [m].
  WedgeWatch(const CaseScene& scene, const WedgePlanes& planes, double length);

  /// To be called after each step. False when there is nothing more to see: the wedge has gone far enough, or lies
  /// still.
  bool look(const Simulation& simulation, const StepReport& report);
  WedgeMotion motion() const;

 private:
  struct Mark {
    Vec3 displacement = Vec3::Zero();
    double rotation = 0;
  };
  void add_forces(const Simulation& simulation);
  WedgeMode mode(const WedgeMotion& motion) const;

  WedgePlanes planes_;
  double length_, weight_, gravity_;
  std::optional<Mark> start_;  // at 5 %
  Mark last_;
  int steps_ = 0, iterations_ = 0;
  int looks_ = 0;                     // since start_
  std::array<double, 2> on_plane_{};  // N, normal forces summed since start_
  double on_neither_ = 0;             // N
};

}  // namespace talus
