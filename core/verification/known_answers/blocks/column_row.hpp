#pragma once

#include <vector>

#include "verification/known_answers/support/known_case.hpp"

/// Goodman and Bray's row of columns that topple over each other down a stepped base (1976): limit equilibrium and
/// runs.
namespace talus {

/// A row of columns of one width, numbered from the toe; heights grow up to the crest and fall behind it.
struct ColumnRow {
  double width = 10;           ///< m, Δx
  double base_dip = 30;        ///< degrees, of each step
  int count = 16, crest = 10;  ///< columns; number of the one at the crest
  double face_rise = 5;        ///< m, a₁: how far a column's top lies above its lower neighbour's, in the face
  double crest_drop = 5.2;     ///< m, a₂: how far it lies below it, behind the crest
  double base_rise = 1;        ///< m, b: how far its base lies above its lower neighbour's
};

/// Height of each column [m], the lowest first.
std::vector<double> heights(const ColumnRow& row);

/// Force that the lowest column needs from below to be in equilibrium, per weight of a column of height 1 m; not above
/// zero: the row stands. Each column hands on what it cannot bear, toppling or sliding; joints between columns have the
/// friction of their bases. Source: Goodman & Bray 1976; Wyllie & Mah 2004, chapter 9.
double toe_force(const ColumnRow& row, double friction_angle);

/// Friction angle [degrees] at which the toe force vanishes.
double limiting_friction_angle(const ColumnRow& row);

std::vector<KnownCase> column_row_cases();

}  // namespace talus
