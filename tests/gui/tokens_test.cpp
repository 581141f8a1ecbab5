#include <gtest/gtest.h>

#include "widgets/kit/tokens.hpp"

namespace talus {
namespace {

struct Pair {
  const char* name;
  QColor front, back;
  double least;
};

/// WCAG AA: text 7:1 where it is read at length, 4.5:1 else, outlines of controls and curves 3:1.
std::vector<Pair> pairs(const Tokens& tokens) {
  const Colours& c = tokens.colours;
  std::vector<Pair> all{
      {"text/surface", c.text, c.surface, 7},
      {"text/window", c.text, c.window, 7},
      {"text/sunken", c.text, c.sunken, 7},
      {"text/accentSoft", c.text, c.accentSoft, 7},
      {"text/errorSoft", c.text, c.errorSoft, 7},
      {"text/warnSoft", c.text, c.warnSoft, 7},
      {"muted/surface", c.textMuted, c.surface, 4.5},
      {"muted/window", c.textMuted, c.window, 4.5},
      {"muted/accentSoft", c.textMuted, c.accentSoft, 4.5},
      {"muted/sunken", c.textMuted, c.sunken, 4.5},
      {"faint/surface", c.textFaint, c.surface, 4.5},
      {"faint/window", c.textFaint, c.window, 4.5},
      {"faint/accentSoft", c.textFaint, c.accentSoft, 4.5},
      {"accentText/surface", c.accentText, c.surface, 4.5},
      {"accentText/accentSoft", c.accentText, c.accentSoft, 4.5},
      {"onAccent/accent", c.onAccent, c.accent, 4.5},
      {"onAccent/accentHover", c.onAccent, c.accentHover, 4.5},
      {"onAccent/accentPressed", c.onAccent, c.accentPressed, 4.5},
      {"warn/warnSoft", c.warn, c.warnSoft, 4.5},
      {"warn/surface", c.warn, c.surface, 4.5},
      {"error/surface", c.error, c.surface, 4.5},
      {"error/errorSoft", c.error, c.errorSoft, 4.5},
      {"ok/okSoft", c.ok, c.okSoft, 4.5},
      {"ok/surface", c.ok, c.surface, 4.5},
      {"outline/surface", c.borderStrong, c.surface, 3},
      {"outline/window", c.borderStrong, c.window, 3},
      {"accent/surface", c.accent, c.surface, 3},
      {"text/viewTop", c.text, c.viewTop, 4.5},
      {"text/viewBottom", c.text, c.viewBottom, 4.5},
      {"pick/viewTop", c.pick, c.viewTop, 3},
  };
  for (const QColor& colour : seriesColours(tokens.dark)) all.push_back({"series/surface", colour, c.surface, 3});
  return all;
}

TEST(Tokens, EveryPairThatIsReadHasEnoughContrast) {
  for (const Tokens* tokens : {&lightTokens(), &darkTokens()})
    for (const Pair& pair : pairs(*tokens))
      EXPECT_GE(contrastRatio(pair.front, pair.back), pair.least) << (tokens->dark ? "dark " : "light ") << pair.name;
}

TEST(Tokens, WhatLiesOverTheViewHidesItsLabels) {
  for (const Tokens* tokens : {&lightTokens(), &darkTokens()}) EXPECT_EQ(tokens->colours.overlay.alpha(), 255);
}

TEST(Tokens, ContrastIsThatOfWcag) {
  EXPECT_NEAR(contrastRatio(Qt::black, Qt::white), 21, 1e-9);
  EXPECT_NEAR(contrastRatio(QColor(0x77, 0x77, 0x77), Qt::white), 4.478, 1e-3);
  EXPECT_EQ(contrastRatio(Qt::white, Qt::black), contrastRatio(Qt::black, Qt::white));
}

}  // namespace
}  // namespace talus
