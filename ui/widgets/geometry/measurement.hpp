#pragma once

#include <QString>
#include <vector>

#include "session/picking.hpp"

namespace talus {

/// What can be measured in the view, by the number of places that it takes: the attitude of one face; the line between
/// two points; the angle and the plane of three.
enum class Measured { face, line, plane };
constexpr int placesFor(Measured what) { return what == Measured::face ? 1 : what == Measured::line ? 2 : 3; }

/// A row of what was measured: "Distance", "12.5 m".
struct MeasuredRow {
  QString name, value;
  bool operator==(const MeasuredRow&) const = default;
};

/// What some places come to, as many as `what` takes. `origin`: the project's, m; points are said in the survey's
/// coordinates. Dip before dip direction, trend before plunge.
std::vector<MeasuredRow> measure(Measured what, const std::vector<PickedPlace>& places, const Vec3& origin);

}  // namespace talus
