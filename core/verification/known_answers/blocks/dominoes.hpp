#pragma once

#include <vector>

#include "verification/known_answers/support/known_case.hpp"

/// A row of dominoes without friction between them and without rebound (van Leeuwen 2010).
namespace talus {

/// Lengths in units of the height h, times in √(h/g).
struct DominoRow {
  double thickness = 0.15, spacing = 0.5;  ///< of a domino; gap between two

  double pitch() const { return thickness + spacing; }
  /// Tilt at which a domino strikes the next [rad].
  double strike() const;
  /// Speed √(gh) of the front across each pitch, when the first domino starts upright with `push` [√(g/h)]: all
  /// dominoes behind lean on each other, energy is kept between strikes, and at a strike the row shares its momentum
  /// with the domino that it strikes. The last numbers tend to the speed of a long row.
  std::vector<double> front_speeds(double push, int count) const;
};

std::vector<KnownCase> domino_cases();

}  // namespace talus
