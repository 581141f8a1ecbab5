#include "study/accuracy/convergence_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace talus {

namespace {

constexpr double lowest_order = 0.05, highest_order = 6;

/// Root mean square of ln distance about the best line of this order.
double misfit(double order, double finest, std::span<const AxisDistance> distances) {
  std::vector<double> constants;
  for (const AxisDistance& one : distances)
    constants.push_back(std::log(one.distance) - std::log(std::pow(one.size, order) - std::pow(finest, order)));
  const double count = static_cast<double>(constants.size());
  const double mean = std::accumulate(constants.begin(), constants.end(), 0.0) / count;
  double sum = 0;
  for (const double constant : constants) sum += (constant - mean) * (constant - mean);
  return std::sqrt(sum / count);
}

/// The misfit falls and rises once: ratios of distances grow with the order.
double best_order(double finest, std::span<const AxisDistance> distances) {
  double low = lowest_order, high = highest_order;
  constexpr int thirds = 80;
  for (int i = 0; i < thirds; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (misfit(a, finest, distances) < misfit(b, finest, distances))
      high = b;
    else
      low = a;
  }
  return (low + high) / 2;
}

/// C·finestᵖ from the distance of the next coarser run.
double finest_error(double order, double finest, const AxisDistance& next) {
  return next.distance / (std::pow(next.size / finest, order) - 1);
}

}  // namespace

std::optional<OrderFit> fit_order(double finest, std::span<const AxisDistance> distances, std::optional<double> theory,
                                  double scatter) {
  if (distances.empty()) return std::nullopt;
  const auto nearer = [](const AxisDistance& a, const AxisDistance& b) { return a.distance < b.distance; };
  const double largest = std::max_element(distances.begin(), distances.end(), nearer)->distance;
  OrderFit fit;
  fit.spread = largest;
  if (largest < rounding) {
    fit.convergence = Convergence::exact;
    return fit;
  }
  if (!theory || largest <= scatter) {
    fit.convergence = largest <= scatter ? Convergence::within_scatter : Convergence::not_expected;
    fit.finest_error = largest;
    return fit;
  }
  if (distances.size() == 1) {
    fit.convergence = Convergence::order_assumed;
    fit.finest_error = finest_error(*theory, finest, distances.front());
    return fit;
  }
  const bool rising = std::is_sorted(distances.begin(), distances.end(), nearer);
  if (rising && distances.front().distance > 0) fit.order = best_order(finest, distances);
  if (fit.order < 2 * lowest_order || fit.order > highest_order - lowest_order) {
    fit.convergence = Convergence::not_monotone;
    fit.order = 0;
    fit.finest_error = largest;
    return fit;
  }
  fit.misfit = std::expm1(misfit(fit.order, finest, distances));
  const bool certain = distances.size() > 2 && fit.misfit < good_fit;
  fit.finest_error = finest_error(certain ? fit.order : std::min(fit.order, *theory), finest, distances.front());
  return fit;
}

}  // namespace talus
