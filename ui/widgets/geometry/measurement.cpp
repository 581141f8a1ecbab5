#include "widgets/geometry/measurement.hpp"

#include <QObject>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/line_attitude.hpp"
#include "base/units.hpp"
#include "orientation/attitude.hpp"
#include "widgets/kit/numbers.hpp"

namespace talus {

namespace {

QString metres(double length) { return QObject::tr("%1 m").arg(numbers::figure(length, 6)); }

QString inDegrees(double angle) { return numbers::fixed(angle, 1) + u'°'; }

QString placeOf(const Vec3& point, const Vec3& origin) {
  const Vec3 surveyed = point + origin;
  return QObject::tr("E %1  N %2  Z %3 m")
      .arg(numbers::fixed(surveyed.x(), 2), numbers::fixed(surveyed.y(), 2), numbers::fixed(surveyed.z(), 2));
}

QString planeOf(const Vec3& normal) {
  const PlaneAttitude plane = attitude_of_normal(normal);
  return numbers::orientation(plane.dip, plane.dip_direction);
}

std::vector<MeasuredRow> ofLine(const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  std::vector<MeasuredRow> rows{{QObject::tr("Distance"), metres(way.norm())},
                                {QObject::tr("Horizontal"), metres(way.head<2>().norm())},
                                {QObject::tr("Vertical"), metres(way.z())}};
  if (way.isZero()) return rows;
  const LineAttitude line = attitude_of(way);
  rows.push_back({QObject::tr("Trend / plunge"), QStringLiteral("%1 / %2")
                                                     .arg(std::lround(line.trend) % 360, 3, 10, QLatin1Char('0'))
                                                     .arg(numbers::fixed(line.plunge, 1) + u'°')});
  return rows;
}

/// The angle is that at the second point.
std::vector<MeasuredRow> ofPlane(const Vec3& first, const Vec3& second, const Vec3& third) {
  const Vec3 one = first - second, other = third - second, normal = one.cross(other);
  if (normal.norm() <= 1e-9 * one.norm() * other.norm())
    return {{QObject::tr("Plane"), QObject::tr("the three points lie in a line")}};
  const double angle = degrees(std::atan2(normal.norm(), one.dot(other)));
  return {{QObject::tr("Angle at the second"), inDegrees(angle)},
          {QObject::tr("Dip / direction"), planeOf(normal)},
          {QObject::tr("Area"), QObject::tr("%1 m²").arg(numbers::significant(normal.norm() / 2, 5))}};
}

}  // namespace

std::vector<MeasuredRow> measure(Measured what, const std::vector<PickedPlace>& places, const Vec3& origin) {
  std::vector<MeasuredRow> rows;
  switch (what) {
    case Measured::face:
      rows = {{QObject::tr("Dip / direction"), planeOf(places[0].normal)}};
      break;
    case Measured::line:
      rows = ofLine(places[0].point, places[1].point);
      break;
    case Measured::plane:
      rows = ofPlane(places[0].point, places[1].point, places[2].point);
      break;
  }
  for (const PickedPlace& place : places) rows.push_back({QObject::tr("At"), placeOf(place.point, origin)});
  return rows;
}

}  // namespace talus
