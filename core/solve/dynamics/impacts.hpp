#pragma once

#include <span>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "bodies/impulse.hpp"
#include "contact/contact_point.hpp"
#include "effects/effect.hpp"
#include "model/solver_tolerances.hpp"
#include "solve/dynamics/energy_gain.hpp"
#include "solve/dynamics/integration_reserve.hpp"
#include "solve/dynamics/sweep_layers.hpp"

namespace talus {

/// What impacts do to the energy of a step [J].
struct ImpactEnergy {
  double taken = 0;  ///< from bodies, and from what driven ones give them
  double by_driven =
      0;  ///< work of bodies that are moved by prescription: a base that starts strikes what stands on it
};

/// Newton's law of impact: bodies whose contacts touched in a step part at its end at `restitution` times the speed at
/// which they met. Springs that are stiff for the step throw bodies back at a speed that depends on where in the step
/// they met; impulses correct it (Moreau 1988; nonlinear Gauss–Seidel of Jean 1999). Over the step as a whole a contact
/// never pulls, and shears by no more than its strength. With friction Newton's law can make energy (Kane & Levinson
/// 1985): where rigid bodies that strike each other would have more after a step than before, all of them part at a
/// smaller restitution, the largest at which they do not. Where a joint has no restitution, the rebound is left to
/// springs that the step can follow; bodies that stiffer ones stop do not part.
class Impacts {
 public:
  /// `set` outlives the impacts.
  explicit Impacts(BodySet& set, const ImpactTolerances& tolerances = {})
      : set_(set), tolerances_(tolerances), masses_(set), energy_(set) {}

  /// Before a step is accepted: bodies and contacts are as at its start.
  void note_speeds(const ContactSet& contacts, const StepContext& step);
  /// Before effects and contacts remember the step: springs that have stopped a landing are let go, for what they would
  /// push out later is speed that the law of impact has not given. What is in by then stays out of account until the
  /// contact opens. Returns the energy that was in them [J].
  double let_go_landed(ContactSet& contacts, const StepContext& step, const std::vector<ContactOutcome>& outcomes);
  /// After it was accepted, and bodies have moved; forces and gaps are those at its end. What impacts give to bodies
  /// comes out of `reserve` first.
  ImpactEnergy apply(const ContactSet& contacts, const StepContext& step, const std::vector<ContactOutcome>& outcomes,
                     IntegrationReserve& reserve);

  double seconds() const { return seconds_; }
  long evaluations() const { return evaluations_; }
  long restitutions() const { return restitutions_; }  ///< contacts that pushed and whose joint gives a restitution
  long sweep_limits() const {
    return sweep_limits_;
  }  ///< groups of a step whose impulses were not found within the sweep limit

  /// What it has done so far.
  void archive(auto& state) { state(seconds_, evaluations_, restitutions_, sweep_limits_); }

 private:
  /// Speeds of parting that are left as they are [m/s].
  struct Range {
    double lowest, highest;
    Range towards(const Range& other, double fraction) const {
      return {lowest + fraction * (other.lowest - lowest), highest + fraction * (other.highest - highest)};
    }
  };
  struct Struck {
    int point;
    Range range, inelastic;  // that of its restitution, and of none
    bool parts_as_it_should;
    int group;      // the first body of it; while groups are found, one that moves
    int layer = 0;  // of contacts of the group that are swept over one after the other
  };
  /// A contact that pushed at the end of the step.
  struct Hit {
    StruckPoint where;
    Vec3 normal;
    Range range;               // that is held now …
    Range elastic, inelastic;  // … of Struck's
    std::array<int, 2> bodies;
    double spring_gain;  // J, over the step
    double friction;
    double along = 0;     // 1/kg, the mobility along the normal …
    double sideways = 0;  // 1/kg, … and no less than that in any direction across it
    double push;          // N s, of the springs over the step
    Vec3 shear;           // N s
    double pushed = 0;    // N s, by the impact
    Vec3 sheared = Vec3::Zero();
    double found_push = 0;  // N s, by the impact, before energy was asked for
    Vec3 found_shear = Vec3::Zero();

    bool throws_back() const { return elastic.highest > inelastic.highest; }
    /// Changes what the impact has pushed and sheared; returns by how much [N s].
    double strike(BodySet& set, double push_more, const Vec3& shear_more);
  };
  /// Sums up what pushes each body, [N/m].
  void add_up_springs(const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes);
  /// Whether the springs of a contact that pushes decide its rebound.
  bool left_to_springs(const ContactPoint& point, double step) const;
  Range range(const ContactPoint& point, double restitution, double closing, double speed, const ContactOutcome& end,
              double step) const;
  /// Collects the contacts that pushed, of those groups of bodies which push each other where some do not part as they
  /// should: group by group, so that no blow elsewhere changes what a group comes to.
  void gather(const ContactSet& contacts, double step, const std::vector<ContactOutcome>& outcomes);
  /// Calls use(first contact, how many) for each group.
  template <class Use>
  void each_group(const Use& use);
  /// Puts the contacts of each group in the order of their layers.
  void find_layers(const ContactSet& contacts);
  Hit hit_of(const Struck& struck, const ContactSet& contacts, double step, const ContactOutcome& outcome);
  void find_hits(const ContactSet& contacts, double step, const std::vector<ContactOutcome>& outcomes);
  /// Where the layers of a group begin among its contacts.
  void list_layers(std::span<const Struck> group);
  /// Finds the impulses of the hits of a group, contact by contact, every second layer at once.
  void find_impulses(std::span<Hit> hits);
  /// Goes through all of them once; returns by how much an impulse changed at most [N s].
  double sweep_over(std::span<Hit> hits);
  /// The bodies that hits strike, each once.
  std::vector<int> bodies_of(std::span<const Hit> hits) const;
  /// Work of bodies that are moved by prescription, by springs and impacts [J].
  static double by_driven(std::span<const Hit> hits);
  /// Takes from the restitution of a group what would make energy; where there is none left to take, from the impulses.
  void limit_energy(std::span<Hit> hits, std::span<const int> bodies, double step);
  /// Takes all that hits have pushed over the step from the velocities.
  void take_away(std::span<Hit> hits);
  /// The impulse of one contact while the others stay; returns by how much it changed [N s].
  double update(Hit& hit);

  BodySet& set_;
  ImpactTolerances tolerances_;
  InverseMasses masses_;
  EnergyGain energy_;
  std::vector<double> closing_;  // m/s, of ContactSet::loose at the start of the step
  std::vector<double> springs_;  // N/m, of all contacts that push a body
  std::vector<Struck> struck_;   // group by group
  DisjointSets groups_;          // bodies
  std::vector<char> is_wrong_;   // a body that is the first of its group
  SweepLayers sweep_layers_;
  std::vector<SweepLayers::Pair> pairs_;  // of the contacts of a group
  std::vector<int> layer_begins_;         // of the group at hand: hits
  std::vector<double> changes_;           // N s, of each layer in a sweep
  std::vector<Hit> hits_;
  double seconds_ = 0;
  long evaluations_ = 0, restitutions_ = 0, sweep_limits_ = 0;
};

}  // namespace talus
