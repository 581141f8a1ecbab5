#pragma once

#include <QPointF>
#include <functional>
#include <optional>
#include <vector>

#include "model/rock/cut.hpp"
#include "render/scene/scene.hpp"

/// What a cut is taken hold of by in the 3-D view, and what comes of it.
namespace talus {

/// A ring turns the dip direction, an arc the dip, an arrow moves the plane along its normal; a disc has its radius, a
/// polygon its corners.
struct CutHandle {
  enum class Kind { direction, dip, move, radius, corner };
  Kind kind = Kind::move;
  int corner = -1;  ///< of a polygon
  bool operator==(const CutHandle&) const = default;
};

/// Where handles of a cut stand, and how large.
struct HandleFrame {
  Vec3 centre = Vec3::Zero();  ///< m, a point of the cut's plane
  double radius = 1;           ///< m, of ring and arc
};

std::vector<CutHandle> handlesOf(const Cut& cut);

/// What a handle stands at: degrees, or m; how far the plane has been moved is 0.
double valueOf(const CutHandle& handle, const Cut& cut);

/// The cut with a handle at another value, held in the limits of the project file. A plane is turned about `pivot`.
/// Of a polygon's corner nothing changes.
Cut withValue(const Cut& cut, const CutHandle& handle, double value, const Vec3& pivot);

/// The place of a handle's knob for a value that it may have.
Vec3 knobPlace(const CutHandle& handle, const Cut& cut, const HandleFrame& frame, double value);

/// The line along which a knob slides, end to end; empty for a corner.
std::vector<Vec3> slideOf(const CutHandle& handle, const Cut& cut, const HandleFrame& frame);

/// The value at which a knob is nearest to a point of the view, looked for near the one that it has.
double valueUnder(const CutHandle& handle, const Cut& cut, const HandleFrame& frame, QPointF point, double near,
                  const std::function<std::optional<QPointF>(const Vec3&)>& pointOf);

/// Where a line of sight meets the plane of a cut; empty where it runs along it.
std::optional<Vec3> onPlane(const Cut& cut, const SightLine& sight);

}  // namespace talus
