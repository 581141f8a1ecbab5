#pragma once

#include <functional>

namespace talus {

/// A parameter between one at which a scene falls and one at which it stands.
struct Bracket {
  double falls = 0, stands = 0;
  double middle() const { return (falls + stands) / 2; }
};

/// Halves the bracket `runs` times; `falls_at` says what a run at a parameter does.
inline Bracket narrowed(Bracket bracket, int runs, const std::function<bool(double)>& falls_at) {
  for (int i = 0; i < runs; ++i) {
    const double middle = bracket.middle();
    (falls_at(middle) ? bracket.falls : bracket.stands) = middle;
  }
  return bracket;
}

}  // namespace talus
