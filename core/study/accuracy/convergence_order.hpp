#pragma once

#include <optional>
#include <span>

namespace talus {

/// How far a run of some step or mesh size is from the finest run of its axis.
struct AxisDistance {
  double size = 1;      ///< in units of the project's own
  double distance = 0;  ///< of its answer from that of the finest, relative
};

/// Differences below this are rounding.
inline constexpr double rounding = 1e-10;
/// Three distances that fit an order this well do not do so by chance.
inline constexpr double good_fit = 0.1;

enum class Convergence {
  converging,      ///< distances fall with the size, by `order`
  exact,           ///< all runs agree to rounding
  not_monotone,    ///< distances do not fall with the size: no order can be told
  order_assumed,   ///< two runs only: theory's order was taken
  not_expected,    ///< theory knows no order: answers scatter
  within_scatter,  ///< answers differ by no more than repeats of one run scatter
};
constexpr const char* to_string(Convergence convergence) {
  constexpr const char* words[] = {"converging",    "exact",        "not monotone",
                                   "order assumed", "not expected", "within scatter"};
  return words[static_cast<int>(convergence)];
}

struct OrderFit {
  Convergence convergence = Convergence::converging;
  double order = 0;         ///< p in error = C·sizeᵖ; only while converging
  double misfit = 0;        ///< root mean square of distances about the fit, relative; 0 with two distances
  double spread = 0;        ///< the largest distance: how much the axis matters at all
  double finest_error = 0;  ///< estimated error of the finest run, by Richardson's extrapolation
};

/// Fits distance = C (sizeᵖ − finestᵖ) by least squares of logarithms: what remains of error = C·sizeᵖ once it is
/// measured from the finest run instead of the answer, which need not be known. The finest run's own error C·finestᵖ
/// follows from the nearest distance, with `theory`'s order where the observed one is higher (a coarse run may come
/// nearer by chance) unless three distances or more fit it within `good_fit`, and is the largest distance where nothing
/// converges or `theory` is none. `distances`: ascending sizes, all above `finest`. Nothing without any distance.
/// Distances of `scatter` and less are chance, and no order comes of them.
std::optional<OrderFit> fit_order(double finest, std::span<const AxisDistance> distances, std::optional<double> theory,
                                  double scatter = 0);

}  // namespace talus
