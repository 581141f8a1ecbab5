#include "model/about_text.hpp"

#include <algorithm>
#include <cmath>

#include "model/number_text.hpp"

namespace talus {

std::string about_text(double count) {
  constexpr double readable = 1e7;  // below it all figures are written
  if (!(count >= 1)) return number_text(std::ceil(count));
  const double digit = std::pow(10.0, std::max(0.0, std::floor(std::log10(count)) - 1));
  const double rounded = digit * std::round(count / digit);
  return rounded < readable ? count_text(std::lround(rounded)) : number_text(rounded);
}

}  // namespace talus
