#include "verification/known_answers/blocks/voussoirs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

namespace {

constexpr double thickest = 0.5;

struct Line {
  double slope, offset;
  double at(double x) const { return slope * x + offset; }
};

/// What equilibrium and friction ask of the thrust H at the springing and of its moment M about the centre: M between
/// the greatest of `lower` and the least of `upper` at that H.
struct ThrustBounds {
  double least_thrust = 0, largest_thrust = 0;
  std::vector<Line> lower, upper;

  double room(double thrust) const {
    double top = 1e300, bottom = -1e300;
    for (const Line& line : upper) top = std::min(top, line.at(thrust));
    for (const Line& line : lower) bottom = std::max(bottom, line.at(thrust));
    return top - bottom;
  }
};

struct Weight {
  double area = 0, first_moment = 0;  ///< ∫dA, ∫x dA
};

Weight weight_of(const Arch& arch, int i) {
  const auto c = corners(arch, i);
  const std::array<Eigen::Vector2d, 4> ring{c[0], c[1], c[3], c[2]};
  Weight weight;
  for (int k = 0; k < 4; ++k) {
    const auto &a = ring[k], &b = ring[(k + 1) % 4];
    const double cross = a.x() * b.y() - a.y() * b.x();
    weight.area += cross / 2;
    weight.first_moment += cross * (a.x() + b.x()) / 6;
  }
  return weight;
}

/// |H cos θ − V sin θ| ≤ μ (H sin θ + V cos θ), as bounds of H.
void bound_by_friction(ThrustBounds& bounds, double vertical, double sine, double cosine, double friction) {
  bounds.least_thrust =
      std::max(bounds.least_thrust, vertical * (sine - friction * cosine) / (cosine + friction * sine));
  const double limit = vertical * (sine + friction * cosine) / (cosine - friction * sine);
  if (cosine > friction * sine) bounds.largest_thrust = std::min(bounds.largest_thrust, limit);
}

ThrustBounds thrust_bounds(const Arch& arch, std::optional<double> friction) {
  Weight whole;
  for (int i = 0; i < arch.voussoirs; ++i) whole.area += weight_of(arch, i).area;
  ThrustBounds bounds;
  bounds.largest_thrust = 10 * whole.area;
  const double inner = 1 - arch.thickness / 2, outer = 1 + arch.thickness / 2;
  Weight below;
  // The arch is symmetric, so joints of one half speak for all.
  for (int i = 0; i <= arch.voussoirs / 2; ++i) {
    const double angle = std::numbers::pi * i / arch.voussoirs, sine = std::sin(angle), cosine = std::cos(angle);
    const double vertical = whole.area / 2 - below.area;
    // Normal force N = H sin θ + V cos θ; its moment about the centre is M less that of the weights below.
    bounds.lower.push_back({inner * sine, inner * vertical * cosine + below.first_moment});
    bounds.upper.push_back({outer * sine, outer * vertical * cosine + below.first_moment});
    if (friction) bound_by_friction(bounds, vertical, sine, cosine, *friction);
    const Weight next = weight_of(arch, i);
    below.area += next.area;
    below.first_moment += next.first_moment;
  }
  return bounds;
}

}  // namespace

std::array<Eigen::Vector2d, 4> corners(const Arch& arch, int i) {
  std::array<Eigen::Vector2d, 4> points;
  for (int k = 0; k < 4; ++k) {
    const double angle = std::numbers::pi * (i + (k >> 1)) / arch.voussoirs;
    const double radius = 1 + (k & 1 ? 0.5 : -0.5) * arch.thickness;
    points[k] = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return points;
}

std::array<Vec3, 8> voussoir(const Arch& arch, int i, double radius, double depth) {
  const auto section = corners(arch, i);
  std::array<Vec3, 8> stone;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector2d& point = section[(k & 1) + (k & 4 ? 2 : 0)];
    stone[k] = Vec3(radius * point.x(), k & 2 ? depth / 2 : -depth / 2, radius * point.y());
  }
  return stone;
}

bool stands(const Arch& arch, std::optional<double> friction) {
  const ThrustBounds bounds = thrust_bounds(arch, friction);
  double low = bounds.least_thrust, high = bounds.largest_thrust;
  if (low > high) return false;
  // The room is a concave function of the thrust: thirds close in on its largest value.
  for (int i = 0; i < 200; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (bounds.room(a) < bounds.room(b) ? low : high) = bounds.room(a) < bounds.room(b) ? a : b;
  }
  return bounds.room((low + high) / 2) >= 0;
}

std::optional<double> least_thickness(int voussoirs, std::optional<double> friction) {
  double falls = 0.01, stays = thickest;
  if (!stands({voussoirs, stays}, friction)) return std::nullopt;
  for (int i = 0; i < 50; ++i) {
    const double middle = (falls + stays) / 2;
    (stands({voussoirs, middle}, friction) ? stays : falls) = middle;
  }
  return stays;
}

std::optional<double> least_friction(const Arch& arch) {
  constexpr double roughest = 10;
  double falls = 0, stays = roughest;
  if (!stands(arch, stays)) return std::nullopt;
  for (int i = 0; i < 50; ++i) {
    const double middle = (falls + stays) / 2;
    (stands(arch, middle) ? stays : falls) = middle;
  }
  return stays;
}

}  // namespace talus
