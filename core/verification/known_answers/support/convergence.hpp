#pragma once

#include "verification/known_answers/support/known_case.hpp"

/// How a number behaves when mesh or step is halved again and again.
namespace talus {

/// One run of such a series.
struct Refinement {
  std::string name;  ///< "40 cells", "1.25e-4 s"
  double value = 0;
  double error = 0;  ///< relative to the known answer
};

/// p in error ~ hᵖ, from the errors at h and h/2.
double observed_order(double coarse_error, double fine_error);

/// The value that a series converges to with a known order, from its values at h and h/2.
double richardson_limit(double coarse_value, double fine_value, double order);

/// A row a run, coarsest first: its name, value, error and the order that it and the run before it show.
CaseTable convergence_table(const std::string& title, const std::string& name_column, const std::string& value_column,
                            const std::vector<Refinement>& series);

/// A number with six digits, for tables.
std::string short_number(double value);

}  // namespace talus
