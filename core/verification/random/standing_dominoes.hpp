#pragma once

namespace talus {

/// Dominoes that stand upright, all the same, at equal distances. Lengths in m.
struct StandingDominoes {
  int count = 0;
  double height = 0, thickness = 0;
  double gap = 0;  ///< from one to the next

  /// Leaning by this, a domino tips over by its own weight [degrees].
  double tipping_angle() const;
  /// Leaning by this, it meets the next [degrees].
  double leaning_angle() const;
  /// The spin about its lower edge that carries its middle just over that, by energy: I ω²/2 = m g (r − h/2) with
  /// I = 4/3 m r², r from the edge to the middle [rad/s].
  double tipping_spin() const;
  /// Whether a domino that leans at rest on the next, held by friction [degrees] against each other and the floor,
  /// overturns it with more than `share` of the moment that this takes. Statics of both about their lower front edges,
  /// with all of the friction between them against it.
  bool leaning_overturns(double friction, double share) const;
};

}  // namespace talus
