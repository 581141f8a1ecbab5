#include "report/table_layout.hpp"

#include <algorithm>

namespace talus::report {

std::vector<double> column_widths(const std::vector<ColumnNeed>& needs, double room) {
  double least = 0, natural = 0;
  for (const ColumnNeed& need : needs) {
    least += need.least;
    natural += need.natural;
  }
  const double given = natural > least ? std::clamp((room - least) / (natural - least), 0.0, 1.0) : 1.0;
  const double squeezed = least > room ? room / least : 1.0;
  std::vector<double> widths;
  for (const ColumnNeed& need : needs) widths.push_back(squeezed * (need.least + given * (need.natural - need.least)));
  return widths;
}

}  // namespace talus::report
