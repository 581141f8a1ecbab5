#include "widgets/joints/cut_handles.hpp"

#include <QLineF>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.hpp"
#include "orientation/cut_moves.hpp"

namespace talus {

namespace {

constexpr double arrow = 0.85;         // of the ring's radius: from the plane to the arrow's knob
constexpr double least_radius = 0.01;  // m
constexpr double knob_turn = 45;  // degrees from where a knob is that are looked at: rings seen edge on double back

Vec3 level(double azimuth) { return {std::sin(radians(azimuth)), std::cos(radians(azimuth)), 0}; }

/// Values at which the nearest place is looked for, and how finely.
struct Search {
  double low, high, step;
};

Search searchOf(const CutHandle& handle, const HandleFrame& frame, double near) {
  switch (handle.kind) {
    case CutHandle::Kind::direction:
      return {near - knob_turn, near + knob_turn, 1};
    case CutHandle::Kind::dip:
      return {std::max(0.0, near - knob_turn), std::min(90.0, near + knob_turn), 1};
    case CutHandle::Kind::radius:
      return {least_radius, std::max(2 * near, near + 20 * frame.radius), frame.radius / 20};
    case CutHandle::Kind::move:
    case CutHandle::Kind::corner:
      break;
  }
  return {near - 20 * frame.radius, near + 20 * frame.radius, frame.radius / 20};
}

}  // namespace

std::vector<CutHandle> handlesOf(const Cut& cut) {
  using Kind = CutHandle::Kind;
  std::vector<CutHandle> handles{{Kind::direction}, {Kind::dip}, {Kind::move}};
  if (cut.disc) handles.push_back({Kind::radius});
  for (std::size_t i = 0; i < cut.polygon.size(); ++i) handles.push_back({Kind::corner, static_cast<int>(i)});
  return handles;
}

double valueOf(const CutHandle& handle, const Cut& cut) {
  switch (handle.kind) {
    case CutHandle::Kind::direction:
      return cut.dip_direction;
    case CutHandle::Kind::dip:
      return cut.dip;
    case CutHandle::Kind::radius:
      return cut.disc ? cut.disc->radius : 0;
    case CutHandle::Kind::move:
    case CutHandle::Kind::corner:
      break;
  }
  return 0;
}

Cut withValue(const Cut& cut, const CutHandle& handle, double value, const Vec3& pivot) {
  switch (handle.kind) {
    case CutHandle::Kind::direction:
      return turned(cut, {cut.dip, azimuth_within_circle(value)}, pivot);
    case CutHandle::Kind::dip:
      return turned(cut, {std::clamp(value, 0.0, 90.0), cut.dip_direction}, pivot);
    case CutHandle::Kind::move:
      return moved(cut, value);
    case CutHandle::Kind::radius: {
      Cut wider = cut;
      if (wider.disc) wider.disc->radius = std::max(least_radius, value);
      return wider;
    }
    case CutHandle::Kind::corner:
      break;
  }
  return cut;
}

Vec3 knobPlace(const CutHandle& handle, const Cut& cut, const HandleFrame& frame, double value) {
  switch (handle.kind) {
    case CutHandle::Kind::direction:
      return frame.centre + frame.radius * level(value);
    case CutHandle::Kind::dip:
      return frame.centre + frame.radius * (std::cos(radians(value)) * level(cut.dip_direction) -
                                            std::sin(radians(value)) * Vec3::UnitZ());
    case CutHandle::Kind::move:
      return frame.centre + (arrow * frame.radius + value) * normal_of(cut);
    case CutHandle::Kind::radius:
      return frame.centre - value * level(cut.dip_direction + 90);
    case CutHandle::Kind::corner:
      break;
  }
  return cut.polygon.at(static_cast<std::size_t>(handle.corner));
}

std::vector<Vec3> slideOf(const CutHandle& handle, const Cut& cut, const HandleFrame& frame) {
  std::vector<Vec3> points;
  const auto add = [&](double value) { points.push_back(knobPlace(handle, cut, frame, value)); };
  if (handle.kind == CutHandle::Kind::direction)
    for (int azimuth = 0; azimuth <= 360; azimuth += 5) add(azimuth);
  if (handle.kind == CutHandle::Kind::dip)
    for (int dip = 0; dip <= 90; dip += 5) add(dip);
  if (handle.kind == CutHandle::Kind::move || handle.kind == CutHandle::Kind::radius) {
    points.push_back(frame.centre);
    add(valueOf(handle, cut));
  }
  return points;
}

double valueUnder(const CutHandle& handle, const Cut& cut, const HandleFrame& frame, QPointF point, double near,
                  const std::function<std::optional<QPointF>(const Vec3&)>& pointOf) {
  const auto nearest = [&](const Search& search) {
    double best = near, least = std::numeric_limits<double>::infinity();
    for (double value = search.low; value <= search.high; value += search.step) {
      const auto at = pointOf(knobPlace(handle, cut, frame, value));
      if (!at) continue;
      const double away = QLineF(*at, point).length();
      if (away >= least) continue;
      least = away;
      best = value;
    }
    return best;
  };
  const Search coarse = searchOf(handle, frame, near);
  const double found = nearest(coarse);
  return nearest(
      {std::max(coarse.low, found - coarse.step), std::min(coarse.high, found + coarse.step), coarse.step / 50});
}

std::optional<Vec3> onPlane(const Cut& cut, const SightLine& sight) {
  constexpr double grazing = 0.02;
  const Vec3 normal = normal_of(cut);
  const double facing = normal.dot(sight.along);
  if (std::abs(facing) < grazing) return std::nullopt;
  return sight.from + normal.dot(cut.through - sight.from) / facing * sight.along;
}

}  // namespace talus
