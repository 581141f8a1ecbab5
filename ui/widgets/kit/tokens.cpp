#include "widgets/kit/tokens.hpp"

#include <cmath>
#include <utility>

namespace talus {

namespace {

QColor rgb(const char* hex) { return QColor(QLatin1String(hex)); }

Tokens makeLight() {
  Tokens tokens;
  auto& c = tokens.colours;
  c.window = rgb("#f3f4f2");
  c.surface = rgb("#ffffff");
  c.raised = rgb("#ffffff");
  c.sunken = rgb("#e9ebe8");
  c.border = rgb("#dcdfdb");
  c.borderStrong = rgb("#868e89");
  c.text = rgb("#1b211f");
  c.textMuted = rgb("#535d59");
  c.textFaint = rgb("#5f6864");
  c.hover = rgb("#eceeeb");
  c.pressed = rgb("#e0e3df");
  c.accent = rgb("#0b6a80");
  c.accentHover = rgb("#095a6d");
  c.accentPressed = rgb("#074a5a");
  c.onAccent = rgb("#ffffff");
  c.accentSoft = rgb("#dcebef");
  c.accentText = rgb("#0a5f73");
  c.ok = rgb("#22703f");
  c.okSoft = rgb("#e0f0e5");
  c.warn = rgb("#8a5a00");
  c.warnSoft = rgb("#faefd6");
  c.error = rgb("#b3261e");
  c.errorSoft = rgb("#fbe4e2");
  c.viewTop = rgb("#dde3e6");
  c.viewBottom = rgb("#f7f8f8");
  c.edge = rgb("#3a4340");
  c.rock = rgb("#c9c6bd");
  c.pick = rgb("#d2580a");
  c.overlay = rgb("#ffffff");
  c.overlayBorder = rgb("#d3d8d6");
  c.grid = rgb("#e6e8e5");
  return tokens;
}

Tokens makeDark() {
  Tokens tokens;
  tokens.dark = true;
  auto& c = tokens.colours;
  c.window = rgb("#191c1d");
  c.surface = rgb("#212526");
  c.raised = rgb("#2a2f30");
  c.sunken = rgb("#141718");
  c.border = rgb("#343a3b");
  c.borderStrong = rgb("#747e7c");
  c.text = rgb("#e7eae9");
  c.textMuted = rgb("#adb6b3");
  c.textFaint = rgb("#9aa3a0");
  c.hover = rgb("#2b3031");
  c.pressed = rgb("#353b3c");
  c.accent = rgb("#57b4c9");
  c.accentHover = rgb("#70c2d5");
  c.accentPressed = rgb("#8dd0df");
  c.onAccent = rgb("#08222a");
  c.accentSoft = rgb("#1d3b44");
  c.accentText = rgb("#7cc9da");
  c.ok = rgb("#6cc08b");
  c.okSoft = rgb("#1d3527");
  c.warn = rgb("#e0b050");
  c.warnSoft = rgb("#3a301a");
  c.error = rgb("#f0877f");
  c.errorSoft = rgb("#432523");
  c.viewTop = rgb("#2c3335");
  c.viewBottom = rgb("#454d50");
  c.edge = rgb("#0e1212");
  c.rock = rgb("#a3a198");
  c.pick = rgb("#ff9a4d");
  c.overlay = rgb("#1e2223");
  c.overlayBorder = rgb("#41494a");
  c.grid = rgb("#303637");
  return tokens;
}

double luminance(const QColor& colour) {
  auto linear = [](double v) { return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

}  // namespace

const Tokens& lightTokens() {
  static const Tokens tokens = makeLight();
  return tokens;
}

const Tokens& darkTokens() {
  static const Tokens tokens = makeDark();
  return tokens;
}

const std::array<QColor, 6>& seriesColours(bool dark) {
  static const std::array<QColor, 6> light{rgb("#0068a8"), rgb("#c0208c"), rgb("#00806f"),
                                           rgb("#7a5048"), rgb("#7a3fa0"), rgb("#6f6a00")};
  static const std::array<QColor, 6> darkened{rgb("#5db3ea"), rgb("#f86ab8"), rgb("#3fc7b3"),
                                              rgb("#dcc0b0"), rgb("#c79be6"), rgb("#cfc84a")};
  return dark ? darkened : light;
}

QColor disabledText(const Colours& colours) {
  constexpr double share = 0.5;  // of the faintest text, over the surface
  const auto mixed = [&](int text, int surface) { return qRound(share * text + (1 - share) * surface); };
  const QColor &text = colours.textFaint, &surface = colours.raised;
  return {mixed(text.red(), surface.red()), mixed(text.green(), surface.green()), mixed(text.blue(), surface.blue())};
}

double contrastRatio(const QColor& a, const QColor& b) {
  double bright = luminance(a), dim = luminance(b);
  if (bright < dim) std::swap(bright, dim);
  return (bright + 0.05) / (dim + 0.05);
}

}  // namespace talus
