#pragma once

#include <vector>

#include "bodies/impulse.hpp"
#include "contact/contact_point.hpp"
#include "effects/effect.hpp"

namespace talus {

/// Newton's law of impact: where contacts have touched in a step, bodies part at its end at `restitution` times the
/// speed at which they met. Springs that are stiff for the step throw bodies back at a speed that depends on where in
/// the step they met; what they gave too much is taken back by impulses, and what they gave too little is added (Moreau
/// 1988; nonlinear Gauss–Seidel of Jean 1999). Over the step as a whole a contact never pulls, and shears by no more
/// than its strength. A joint without a restitution leaves the rebound to blocks that deform and to springs that the
/// step can follow; rigid bodies that stiffer ones stop do not part.
class Impacts {
 public:
  /// `set` outlives the impacts.
  explicit Impacts(BodySet& set) : set_(set), masses_(set) {}

  /// A step is about to be accepted: bodies and contacts are as at its start.
  void note_speeds(const ContactSet& contacts, const StepContext& step);
  /// It has been, and bodies have moved; forces and gaps are those at its end. Returns the kinetic energy that impacts
  /// take [J].
  double take(const ContactSet& contacts, const StepContext& step, const std::vector<ContactOutcome>& outcomes);

  double seconds() const { return seconds_; }
  long evaluations() const { return evaluations_; }

 private:
  /// Speeds of parting that are left as they are [m/s].
  struct Range {
    double lowest, highest;
  };
  struct Struck {
    int point;
    Range range;
  };
  /// A contact that pushed at the end of the step.
  struct Hit {
    StruckPoint where;
    Vec3 normal;
    Range range;
    double friction;
    double push;        // N s, of the springs over the step
    Vec3 shear;         // N s
    double pushed = 0;  // N s, by the impact
    Vec3 sheared = Vec3::Zero();
  };
  /// Sums up what pushes each body, [N/m].
  void add_up_springs(const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes);
  /// Whether the rebound of a contact that pushes is its springs' affair.
  bool left_to_springs(const ContactPoint& point, double step) const;
  Range range(const ContactPoint& point, double closing, double speed, const ContactOutcome& end, double step) const;
  /// Whether some contact that pushed does not part as it should.
  bool gather(const ContactSet& contacts, double step, const std::vector<ContactOutcome>& outcomes);
  double relax(Hit& hit);

  BodySet& set_;
  InverseMasses masses_;
  std::vector<double> closing_;  // m/s, of ContactSet::loose at the start of the step
  std::vector<double> springs_;  // N/m, of all contacts that push a body
  std::vector<Struck> struck_;
  std::vector<Hit> hits_;
  double seconds_ = 0;
  long evaluations_ = 0;
};

}  // namespace talus
