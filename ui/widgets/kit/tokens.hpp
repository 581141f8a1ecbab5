#pragma once

#include <QColor>
#include <array>

/// The look's tokens: the one place where the window's colours, sizes and type are decided. Nothing else names a
/// colour.
namespace talus {

struct Colours {
  // Planes, back to front: window < surface < raised; sunken is the well of fields and tracks.
  QColor window, surface, raised, sunken;
  QColor border, borderStrong;        ///< hairlines; outlines of controls (3:1)
  QColor text, textMuted, textFaint;  ///< 7:1, 4.5:1, 4.5:1 on surface and window
  QColor hover, pressed;              ///< neutral washes
  // Petrol means selected, running, primary; never decoration.
  QColor accent, accentHover, accentPressed, onAccent, accentSoft, accentText;
  QColor ok, okSoft, warn, warnSoft, error, errorSoft;
  QColor viewTop, viewBottom, edge, rock, pick;  ///< 3-D view; pick is for selection in it alone
  QColor overlay, overlayBorder, grid;
};

/// Logical pixels on a 4-pixel grid.
struct Metrics {
  int radiusSmall = 4, radius = 6, radiusLarge = 10;
  int control = 26, row = 26, bar = 40, header = 32, rail = 76, status = 24;
  int icon = 16, iconRail = 22;
};

/// Pixels, not points, so that a screenshot is the same on every machine.
struct Type {
  int small = 11, body = 12, title = 13, large = 18, display = 24;
};

struct Tokens {
  bool dark = false;
  Colours colours;
  Metrics metrics;
  Type type;
};

const Tokens& lightTokens();
const Tokens& darkTokens();

/// Curves, joints and monitors: P. Tol's "vibrant", its lightness moved per theme so that each keeps 3:1 on a surface.
const std::array<QColor, 6>& seriesColours(bool dark);

/// What cannot be used now: plainly fainter than any text that is to be read.
QColor disabledText(const Colours& colours);

/// Contrast ratio of WCAG 2, 1…21. Both colours opaque.
double contrastRatio(const QColor& a, const QColor& b);

}  // namespace talus
