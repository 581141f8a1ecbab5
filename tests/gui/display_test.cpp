// What the user sees of the 3-D view where the driver draws it. Another class draws it on the `offscreen` platform:
// display_test.sh runs these on an X server.
#include <QAction>
#include <QApplication>
#include <QScreen>

#include "driven_window.hpp"
#include "listed_runs.hpp"

namespace talus {
namespace {

class OnADisplay : public DrivenWindow {
 protected:
  void SetUp() override {
    if (QGuiApplication::platformName() == QLatin1String("offscreen")) GTEST_SKIP() << "there is none";
    DrivenWindow::SetUp();
  }
  /// Of points of the view, beside its tools, how many have on the screen what the view has drawn.
  double shareThatIsSeen() {
    Viewport& view = window->viewport();
    const QPoint at = view.mapTo(window.get(), QPoint(0, 0));
    const QImage seen =
        window->screen()->grabWindow(window->winId(), at.x(), at.y(), view.width(), view.height()).toImage();
    const QImage drawn = view.picture().toImage();
    constexpr int step = 16, nearly = 24;  // pixels; of 255
    int points = 0, same = 0;
    for (int y = step; y < view.height() - step; y += step)
      for (int x = step; x < view.tools()->x() - step; x += step) {
        ++points;
        same += std::abs(seen.pixelColor(x, y).lightness() - drawn.pixelColor(x, y).lightness()) < nearly ? 1 : 0;
      }
    return static_cast<double>(same) / points;
  }
};

/// From the start page: the view is hidden there, and gets its place before the panels beside it do.
TEST_F(OnADisplay, TheViewIsSeenWhenAProjectIsOpenedFromTheStartPage) {
  openAndMesh(slidingCube(5));
  rest(300);
  EXPECT_GT(shareThatIsSeen(), 0.95) << "the first project";
  for (auto* action : window->actions())
    if (action->text() == QStringLiteral("Start page")) action->trigger();
  rest(300);
  openAndMesh(sample("free_fall"));
  rest(500);
  EXPECT_GT(shareThatIsSeen(), 0.95) << "the next one";
}

TEST_F(OnADisplay, RockFillsTheViewAsSoonAsTheWindowHasBecomeLarger) {
  window->resize(1100, 700);
  openAndMesh(sample("wedge"));
  rest(300);
  window->resize(1500, 950);
  rest(500);
  const Vec3 seen = window->viewport().pose()->position;
  window->viewport().picture();  // draws once more
  EXPECT_LT((window->viewport().pose()->position - seen).norm(), 1e-6 * seen.norm());
}

}  // namespace
}  // namespace talus
