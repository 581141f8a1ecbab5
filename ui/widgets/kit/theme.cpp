#include "widgets/kit/theme.hpp"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QPalette>
#include <QPixmapCache>

#include "widgets/kit/theme_parts.hpp"

namespace talus::theme {

namespace {

const Tokens* current = &lightTokens();

/// The family that could be loaded: Talus Sans is embedded only where the build could make it.
const QString& family() {
  static const QString name = [] {
    bool embedded = true;
    for (const char* weight : {"Regular", "Medium", "SemiBold"}) {
      const QString path = QStringLiteral(":/fonts/TalusSans-%1.otf").arg(QLatin1String(weight));
      embedded = QFile::exists(path) && QFontDatabase::addApplicationFont(path) >= 0 && embedded;
    }
    return embedded ? QStringLiteral("Talus Sans") : QStringLiteral("DejaVu Sans");
  }();
  return name;
}

QPalette palette() {
  const Colours& c = colours();
  const std::pair<QPalette::ColorRole, QColor> roles[] = {{QPalette::Window, c.window},
                                                          {QPalette::WindowText, c.text},
                                                          {QPalette::Base, c.surface},
                                                          {QPalette::AlternateBase, c.window},
                                                          {QPalette::Text, c.text},
                                                          {QPalette::Button, c.surface},
                                                          {QPalette::ButtonText, c.text},
                                                          {QPalette::BrightText, c.error},
                                                          {QPalette::Highlight, c.accentSoft},
                                                          {QPalette::HighlightedText, c.text},
                                                          {QPalette::ToolTipBase, c.raised},
                                                          {QPalette::ToolTipText, c.text},
                                                          {QPalette::PlaceholderText, c.textFaint},
                                                          {QPalette::Link, c.accentText},
                                                          {QPalette::Mid, c.border},
                                                          {QPalette::Dark, c.borderStrong},
                                                          {QPalette::Light, c.raised}};
  QPalette made;
  for (const auto& [role, colour] : roles) made.setColor(role, colour);
  const QColor disabled = disabledText(c);
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    made.setColor(QPalette::Disabled, role, disabled);
  return made;
}

}  // namespace

const Tokens& now() { return *current; }

const QColor& seriesColour(int number) { return seriesColours(now().dark)[static_cast<size_t>(number) % 6]; }

QFont font(int pixels, int weight) {
  QFont made(family());
  made.setPixelSize(pixels);
  made.setWeight(static_cast<QFont::Weight>(weight));
  made.setHintingPreference(QFont::PreferNoHinting);  // the same widths at every scale
  return made;
}

void install(bool dark) {
  current = dark ? &darkTokens() : &lightTokens();
  static bool first = true;
  if (first) QApplication::setStyle(new TalusStyle);
  if (first) QApplication::setWindowIcon(icon(QStringLiteral("logo"), Tone::accent));
  first = false;
  QApplication::setFont(font(now().type.body));
  QApplication::setPalette(palette());
  QPixmapCache::clear();
  qApp->setStyleSheet(styleSheet());
}

}  // namespace talus::theme
