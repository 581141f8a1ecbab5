#include "orientation/pole_density.hpp"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr double fisher_sharpness = 100;  // e^(κ(cos θ − 1)) has the area of a cap of 1/κ of the hemisphere
constexpr double kamb_expected = 3;       // standard deviations; Kamb's own choice

constexpr std::size_t most_levels = 8;

}  // namespace

PoleDensity::PoleDensity(std::vector<Vec3> poles, DensityMethod method) : poles_(std::move(poles)), method_(method) {
  const auto count = static_cast<double>(poles_.size());
  if (poles_.empty()) return;
  if (method == DensityMethod::fisher) {
    sharpness_ = fisher_sharpness;
    // κ cosh(κ cos θ)/sinh κ has a mean of 1 over the hemisphere; for this κ it is κ e^(κ(|cos θ| − 1)) to the last bit
    // near a pole, and less than 1e-80 where it is not.
    scale_ = sharpness_ / count;
  } else {
    sharpness_ = 2 * (1 + count / (kamb_expected * kamb_expected));
    scale_ = sharpness_ / std::sqrt(count * (sharpness_ / 2 - 1));
  }
}

double PoleDensity::operator()(const Vec3& line) const {
  constexpr double farthest = 25;  // exponents: e^−25 of a pole's own density is nothing, and exp takes the time
  double sum = 0;
  for (const Vec3& pole : poles_) {
    const double exponent = sharpness_ * (std::abs(line.dot(pole)) - 1);
    if (exponent > -farthest) sum += std::exp(exponent);
  }
  return sum * scale_;
}

double DensityGrid::at(const Vec2& place) const {
  const auto along = [&](double coordinate) { return std::clamp((coordinate + 1) / 2, 0.0, 1.0) * (size - 1); };
  const double x = along(place.x()), y = along(place.y());
  const int column = std::min(static_cast<int>(x), size - 2), row = std::min(static_cast<int>(y), size - 2);
  const double right = x - column, up = y - row;
  const double* corner = &values[static_cast<std::size_t>(row * size + column)];
  return (1 - up) * ((1 - right) * corner[0] + right * corner[1]) +
         up * ((1 - right) * corner[size] + right * corner[size + 1]);
}

DensityGrid density_grid(const PoleDensity& density, Projection projection, int size) {
  DensityGrid grid{size, {}, 0, Vec3(0, 0, -1)};
  grid.values.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const Vec2 place(2.0 * column / (size - 1) - 1, 2.0 * row / (size - 1) - 1);
      const Vec3 line = unprojected(place, projection);
      grid.values.push_back(density(line));
      if (line.z() > 0 || grid.values.back() <= grid.largest) continue;
      grid.largest = grid.values.back();
      grid.densest = line;
    }
  return grid;
}

std::vector<double> contour_levels(DensityMethod method, double largest) {
  std::vector<double> steps;
  if (method == DensityMethod::kamb)
    steps = {2, 4, 6, 8, 10, 20};
  else
    for (double decade = 0.1; decade < 1000; decade *= 10)
      for (const double factor : {1.0, 2.0, 5.0}) steps.push_back(factor * decade);
  const auto enough = std::ranges::find_if(steps, [&](double step) { return largest / step < most_levels + 1; });
  const double step = enough == steps.end() ? std::ceil(largest / most_levels) : *enough;
  std::vector<double> levels;
  for (std::size_t i = 1; i <= most_levels && static_cast<double>(i) * step < largest; ++i)
    levels.push_back(static_cast<double>(i) * step);
  return levels;
}

}  // namespace talus
