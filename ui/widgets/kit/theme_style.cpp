#include <QFile>
#include <QHash>
#include <QPainter>
#include <QRegularExpression>
#include <QStyleFactory>
#include <QStyleOption>
#include <QTemporaryDir>

#include "widgets/kit/theme.hpp"
#include "widgets/kit/theme_parts.hpp"

namespace talus::theme {

TalusStyle::TalusStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

int TalusStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  switch (metric) {
    case PM_SmallIconSize:
    case PM_ButtonIconSize:
    case PM_ListViewIconSize:
    case PM_TabBarIconSize:
    case PM_ToolBarIconSize:
      return now().metrics.icon;
    case PM_MessageBoxIconSize:
      return 32;
    case PM_TreeViewIndentation:
      return 16;
    case PM_ScrollBarExtent:
      return 10;
    case PM_DockWidgetSeparatorExtent:
    case PM_SplitterWidth:
      return 1;
    case PM_LayoutHorizontalSpacing:
    case PM_LayoutVerticalSpacing:
      return 8;
    case PM_ToolBarItemSpacing:
      return 2;
    default:
      return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

int TalusStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                          QStyleHintReturn* returned) const {
  switch (hint) {
    case SH_ToolTip_WakeUpDelay:
      return 450;
    case SH_EtchDisabledText:
    case SH_DitherDisabledText:
    case SH_ComboBox_Popup:
    case SH_ItemView_ActivateItemOnSingleClick:
      return 0;
    case SH_Slider_AbsoluteSetButtons:
      return Qt::LeftButton;  // a click on the track goes there
    default:
      return QProxyStyle::styleHint(hint, option, widget, returned);
  }
}

/// Of questions and messages.
QIcon TalusStyle::standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const {
  switch (which) {
    case SP_MessageBoxQuestion:
      return icon(QStringLiteral("help"), Tone::accent);
    case SP_MessageBoxInformation:
      return icon(QStringLiteral("info"), Tone::accent);
    case SP_MessageBoxWarning:
      return icon(QStringLiteral("warning"), Tone::warn);
    case SP_MessageBoxCritical:
      return icon(QStringLiteral("error"), Tone::error);
    default:
      return QProxyStyle::standardIcon(which, option, widget);
  }
}

void TalusStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
  if (element != PE_FrameFocusRect) {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    return;
  }
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(colours().accent, 1.5));
  painter->drawRoundedRect(QRectF(option->rect).adjusted(1, 1, -1, -1), 4, 4);
  painter->restore();
}

namespace {

// Pictures of sub-controls must be files: recoloured copies lie in a private folder, one per colour.
QString glyphFile(const char* name, const QColor& colour) {
  static QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("%1-%2.svg").arg(QLatin1String(name), colour.name().mid(1)));
  QFile file(path);
  if (!file.exists() && file.open(QIODevice::WriteOnly)) file.write(recoloured(QLatin1String(name), colour));
  return path;
}

QString cssColour(const QColor& c) {
  if (c.alpha() == 255) return c.name();
  return QStringLiteral("rgba(%1,%2,%3,%4)").arg(c.red()).arg(c.green()).arg(c.blue()).arg(c.alpha());
}

QHash<QString, QString> sheetWords() {
  const Tokens& tokens = now();
  const Colours& c = tokens.colours;
  QHash<QString, QString> words;
  const std::pair<const char*, QColor> colourWords[] = {{"window", c.window},
                                                        {"surface", c.surface},
                                                        {"raised", c.raised},
                                                        {"sunken", c.sunken},
                                                        {"border", c.border},
                                                        {"borderStrong", c.borderStrong},
                                                        {"text", c.text},
                                                        {"textMuted", c.textMuted},
                                                        {"textFaint", c.textFaint},
                                                        {"hover", c.hover},
                                                        {"pressed", c.pressed},
                                                        {"accent", c.accent},
                                                        {"accentHover", c.accentHover},
                                                        {"accentPressed", c.accentPressed},
                                                        {"onAccent", c.onAccent},
                                                        {"accentSoft", c.accentSoft},
                                                        {"accentText", c.accentText},
                                                        {"ok", c.ok},
                                                        {"okSoft", c.okSoft},
                                                        {"warn", c.warn},
                                                        {"warnSoft", c.warnSoft},
                                                        {"error", c.error},
                                                        {"errorSoft", c.errorSoft},
                                                        {"overlay", c.overlay},
                                                        {"overlayBorder", c.overlayBorder},
                                                        {"grid", c.grid}};
  for (const auto& [name, colour] : colourWords) words[QLatin1String(name)] = cssColour(colour);
  words[QStringLiteral("textDisabled")] = cssColour(disabledText(c));
  const std::pair<const char*, int> sizeWords[] = {
      {"rs", tokens.metrics.radiusSmall}, {"r", tokens.metrics.radius},  {"row", tokens.metrics.row},
      {"status", tokens.metrics.status},  {"fBody", tokens.type.body},   {"fSmall", tokens.type.small},
      {"fTitle", tokens.type.title},      {"fLarge", tokens.type.large}, {"fDisplay", tokens.type.display}};
  for (const auto& [name, pixels] : sizeWords) words[QLatin1String(name)] = QStringLiteral("%1px").arg(pixels);
  words[QStringLiteral("gDown")] = glyphFile("chevron-down", c.textMuted);
  words[QStringLiteral("gRight")] = glyphFile("chevron-right", c.textMuted);
  words[QStringLiteral("gCheck")] = glyphFile("check", c.onAccent);
  words[QStringLiteral("gDash")] = glyphFile("dash", c.onAccent);
  return words;
}

}  // namespace

QString styleSheet() {
  QFile file(QStringLiteral(":/theme/talus.qss"));
  if (!file.open(QIODevice::ReadOnly)) {
    qWarning("the style sheet is not in the program");
    return {};
  }
  const QString text = QString::fromUtf8(file.readAll());
  const QHash<QString, QString> words = sheetWords();
  static const QRegularExpression word(QStringLiteral("@([A-Za-z]+)"));
  QString sheet;
  qsizetype last = 0;
  for (auto it = word.globalMatch(text); it.hasNext();) {
    const auto match = it.next();
    const QString name = match.captured(1);
    if (!words.contains(name)) qWarning("style sheet: no token @%s", qPrintable(name));
    sheet += text.mid(last, match.capturedStart() - last) + words.value(name);
    last = match.capturedEnd();
  }
  return sheet + text.mid(last);
}

}  // namespace talus::theme
