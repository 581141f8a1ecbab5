#pragma once

#include <vector>

#include "effects/compose.hpp"

namespace talus {

/// The states in which the paper's open–close iteration holds contacts for a round, section 3: open, stick or slide.
class ContactStates {
 public:
  struct Judgement {
    int changed = 0;            ///< contacts whose state is another than what is held
    double friction_error = 0;  ///< largest change of friction from what the round bore, of its strength
  };

  /// Holds contacts in the states of the end of the last step, with the friction of its forces; new ones stick where
  /// they are open by less than `touching` of their size. The strengths at D = `start` are known.
  void begin(const Composition& composition, double touching, const Increment& start);
  /// Judges the states anew at D, where strengths are known: closed where d_n > 0 (30), sliding where the shear spring
  /// would bear F_n tan φ or more (33). Friction is taken there (36), against the shear displacement on the common
  /// plane, from the normal force that the round bore: one that was open bore none.
  Judgement judge(const Composition& composition, const Increment& d);
  /// Holds what was judged last.
  void take_judged() { held_.swap(judged_); }
  /// Holds none.
  void release(const Composition& composition) const;

 private:
  std::vector<HeldContact> held_, judged_;
};

}  // namespace talus
