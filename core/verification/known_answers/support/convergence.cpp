#include "verification/known_answers/support/convergence.hpp"

#include <cmath>
#include <cstdio>

namespace talus {

double observed_order(double coarse_error, double fine_error) { return std::log2(std::abs(coarse_error / fine_error)); }

double richardson_limit(double coarse_value, double fine_value, double order) {
  return fine_value + (fine_value - coarse_value) / (std::exp2(order) - 1);
}

CaseTable convergence_table(const std::string& title, const std::string& name_column, const std::string& value_column,
                            const std::vector<Refinement>& series) {
  CaseTable table{title, {name_column, value_column, "error", "order"}, {}};
  for (std::size_t i = 0; i < series.size(); ++i) {
    const std::string order = i == 0 ? "" : short_number(observed_order(series[i - 1].error, series[i].error));
    table.rows.push_back({series[i].name, short_number(series[i].value), short_number(series[i].error), order});
  }
  return table;
}

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace talus
