#pragma once

#include <QPainter>

#include "render/stereonet/net_shapes.hpp"

namespace talus {

/// Draws the shapes of a net of `radius` pixels about `centre`, as render/stereonet draws them into pictures.
class NetArtist {
 public:
  NetArtist(QPainter& painter, const QPointF& centre, double radius)
      : painter_(painter), centre_(centre), radius_(radius) {}

  void operator()(const NetFill& shape) const;
  void operator()(const NetLine& shape) const;
  void operator()(const NetMarker& shape) const;
  void operator()(const NetWord& shape) const;

 private:
  QPointF at(const Vec2& place) const { return centre_ + radius_ * QPointF(place.x(), -place.y()); }
  QPolygonF outline(const std::vector<Vec2>& places) const;

  QPainter& painter_;
  QPointF centre_;
  double radius_;
};

inline QColor colourOf(Rgb colour) { return {colour.red, colour.green, colour.blue}; }

}  // namespace talus
