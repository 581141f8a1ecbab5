#pragma once

namespace talus {

/// How much of inertia a static step keeps. In a static stage inertia means nothing but that it keeps loose blocks from
/// running away: what is out of balance moves a mass by F βΔ²/m a step. Where many blocks lean on each other that is a
/// slow way to rest, by some per cent a step. So inertia fades with what is out of balance, by its power of 3/2
/// (switched evolution relaxation: Mulder & van Leer 1985; the power: Gropp, Kaushik, Keyes & Smith 2001), while steps
/// lead no farther than twice as far as those with all of it. What slides or falls stays out of balance and
/// keeps its inertia: it creeps by F βΔ²/m a step.
class FadingInertia {
 public:
  /// All of it, until steps say otherwise.
  void begin_stage() { *this = {}; }
  /// Of the mass, in (0, 1]; a power of two, so that it seldom changes by little.
  double share() const { return share_; }
  /// A step with less than all inertia that did not settle, or led a node too far [m], is to be taken anew with more.
  bool led_astray(bool settled, double displacement) const;
  /// After such a step.
  void restore(bool settled, double displacement);
  /// A step is taken that moved no node farther than `displacement` [m] and left `imbalance`, inertia's force over the
  /// largest force.
  void taken(double displacement, double imbalance);

 private:
  /// With which a step as this one would have led just as far as it may.
  double share_for(double displacement) const;
  double share_ = 1;
  double wanted_ = 1;  ///< by the imbalance alone, in (0, 1]
  double last_imbalance_ = 0;
  double longest_way_ = 0;  ///< m, of a node in a step with all inertia
};

}  // namespace talus
