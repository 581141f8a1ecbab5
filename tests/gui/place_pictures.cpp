// What a place of the window looks like, held to its baseline.
#include <QLabel>
#include <QPlainTextEdit>
#include <QToolButton>

#include "every_place.hpp"
#include "images/baseline.hpp"
#include "widgets/results/export_strip.hpp"
#include "widgets/run/run_panel.hpp"

namespace talus {
namespace {

/// Whether a widget shows how long something took, or when it was: the machine's doing.
bool tellsTheTime(const QWidget& widget) {
  if (qobject_cast<const RunPanel*>(&widget) || qobject_cast<const ExportStrip*>(&widget)) return true;
  if (const auto* log = qobject_cast<const QPlainTextEdit*>(&widget)) return log->isReadOnly();
  if (const auto* label = qobject_cast<const QLabel*>(&widget))
    return label->text().contains(QLatin1String(" steps in "));
  const bool recentFile = qobject_cast<const QToolButton*>(&widget) && widget.accessibleName().endsWith(u".talus");
  return recentFile;
}

/// Small: there are hundreds.
Image small(const QPixmap& picture) {
  const QImage shown = picture.toImage();
  const QImage made = shown.scaled(shown.size() * 3 / 8, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                          .convertToFormat(QImage::Format_RGB888);
  Image image(made.width(), made.height());
  for (int y = 0; y < made.height(); ++y)
    std::copy_n(made.constScanLine(y), 3 * image.width,
                image.rgb.begin() + 3 * static_cast<std::ptrdiff_t>(y) * image.width);
  return image;
}

}  // namespace

void EveryPlace::expectAsItWas(const std::string& place) {
  constexpr int until_fine = 700;  // ms: the fine drawing comes when the camera has rested
  rest(until_fine);
  std::vector<std::unique_ptr<QWidget>> lids;
  for (auto* widget : window->findChildren<QWidget*>())
    if (widget->isVisible() && tellsTheTime(*widget)) {
      lids.push_back(std::make_unique<QWidget>(widget));
      lids.back()->setStyleSheet(QStringLiteral("background: #808080"));
      lids.back()->setAttribute(Qt::WA_StyledBackground);
      lids.back()->resize(widget->size());
      lids.back()->show();
    }
  expect_baseline(small(picture()), "Window." + place + (session->display.isDark() ? ".dark" : ".light"));
}

}  // namespace talus
