#pragma once

#include <QPointF>
#include <QSizeF>
#include <functional>

#include "render/scene/scene.hpp"

class QEvent;

/// What the hand does to the camera. A turntable: z stays up, as the slope does. Lengths in logical pixels of the view.
namespace talus {

/// Turns round the focal point; `azimuth` and `elevation` in degrees, the elevation held short of the poles.
CameraPose turned(CameraPose pose, double azimuth, double elevation);
/// Moves what is at the focal depth by `by` on the screen.
CameraPose panned(CameraPose pose, QPointF by, QSizeF view);
/// `factor` < 1 comes nearer; what lies under `pointer` at the focal depth stays there.
CameraPose zoomed(CameraPose pose, double factor, QPointF pointer, QSizeF view);
/// The other projection, showing what is at the focal depth in the same size.
CameraPose withOtherProjection(CameraPose pose);

/// `share` 0…1 of the way from one pose to another that looks the same way.
CameraPose between(const CameraPose& from, const CameraPose& to, double share);

/// A camera that the mouse moves in a view: the left button turns it, the middle one pans, the wheel zooms at the
/// pointer.
class CameraMouse {
 public:
  explicit CameraMouse(double degrees_of_pixel) : degrees_of_pixel_(degrees_of_pixel) {}

  /// Whether the event was one of these; where it moves the camera, `move` gets where to.
  bool takes(const QEvent& event, const CameraPose& pose, QSizeF view,
             const std::function<void(const CameraPose&)>& move);

 private:
  double degrees_of_pixel_;
  QPointF last_;
};

}  // namespace talus
