#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bodies/body_set.hpp"
#include "bodies/step_context.hpp"
#include "contact/contact_point.hpp"
#include "results/convergence_trouble.hpp"
#include "solve/trouble_advice.hpp"

namespace talus {

/// The hard trial steps of a step: why, where, and what would help. It looks for the place only when a trial step was
/// hard, so that easy ones cost nothing.
class TroubleLog {
 public:
  /// All outlive it. Places are told in coordinates from which bodies are counted at `origin` [m].
  TroubleLog(const Project& project, const BlockSystem& system, const BodySet& bodies, const ContactSet& contacts,
             const Vec3& origin)
      : project_(project), system_(system), bodies_(bodies), contacts_(contacts), origin_(origin) {}

  /// Forgets those of the step before.
  void begin_step(int number);
  /// A trial step was hard at a node (−1: nobody knows where).
  void note(TroubleCause cause, int node, const StepContext& trial, int iterations);
  /// A trial step is refused because two bodies come to lie so deep in each other there, of the mesh size.
  void note_missed_contact(std::span<const int, 2> bodies, const Vec3& position, double depth, const StepContext& trial,
                           int iterations);
  /// The trial step noted last is cut.
  void note_cut() { troubles_.back().cuts = 1; }
  /// The trial step noted last was the last: none shorter is allowed.
  void note_end_of_run() { troubles_.back().ended_run = true; }

  bool run_ended() const { return !troubles_.empty() && troubles_.back().ended_run; }
  const std::vector<ConvergenceTrouble>& all() const { return troubles_; }

 private:
  /// Blocks, joint and position: of the contact of the node's body that is nearest to the node, else of the node. The
  /// chip at that contact, if one of both is one.
  std::optional<Chip> place(int node, ConvergenceTrouble& trouble) const;
  std::optional<Chip> chip_of(int body_a, int body_b) const;
  /// A place on a body, as bodies lie now.
  void set_place(ConvergenceTrouble& trouble, const Vec3& position, int body) const;

  const Project& project_;
  const BlockSystem& system_;
  const BodySet& bodies_;
  const ContactSet& contacts_;
  Vec3 origin_;
  int step_ = 0;
  std::vector<ConvergenceTrouble> troubles_;
};

}  // namespace talus
