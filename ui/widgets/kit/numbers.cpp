#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

#include <QCoreApplication>
#include <QRegularExpression>
#include <cmath>

#include "render/paint/numbers.hpp"

namespace talus::numbers {

QString fixed(double value, int decimals) { return text(format_decimals(value, decimals)); }

QString significant(double value, int figures) { return text(format_number(value, figures)); }

QString figure(double value, int figures) {
  static const QRegularExpression zeros(QStringLiteral("(\\.\\d*?)0+(?!\\d)")), point(QStringLiteral("\\.(?!\\d)"));
  return significant(value, figures).replace(zeros, QStringLiteral("\\1")).remove(point);
}

QString nounFor(int count, const char* noun) {
  // What is counted anywhere: the translators' tool finds it here.
  static const char* const known[] = {
      QT_TRANSLATE_N_NOOP("counted", "block"),   QT_TRANSLATE_N_NOOP("counted", "corner"),
      QT_TRANSLATE_N_NOOP("counted", "cut"),     QT_TRANSLATE_N_NOOP("counted", "error"),
      QT_TRANSLATE_N_NOOP("counted", "face"),    QT_TRANSLATE_N_NOOP("counted", "frame"),
      QT_TRANSLATE_N_NOOP("counted", "hint"),    QT_TRANSLATE_N_NOOP("counted", "iteration"),
      QT_TRANSLATE_N_NOOP("counted", "joint"),   QT_TRANSLATE_N_NOOP("counted", "line"),
      QT_TRANSLATE_N_NOOP("counted", "load"),    QT_TRANSLATE_N_NOOP("counted", "material"),
      QT_TRANSLATE_N_NOOP("counted", "plane"),   QT_TRANSLATE_N_NOOP("counted", "pole"),
      QT_TRANSLATE_N_NOOP("counted", "row"),     QT_TRANSLATE_N_NOOP("counted", "solid"),
      QT_TRANSLATE_N_NOOP("counted", "stage"),   QT_TRANSLATE_N_NOOP("counted", "step"),
      QT_TRANSLATE_N_NOOP("counted", "support"), QT_TRANSLATE_N_NOOP("counted", "thread"),
      QT_TRANSLATE_N_NOOP("counted", "time"),    QT_TRANSLATE_N_NOOP("counted", "triangle"),
      QT_TRANSLATE_N_NOOP("counted", "warning")};
  static_cast<void>(known);
  const QString said = QCoreApplication::translate("counted", noun, nullptr, count);
  const bool translated = said != QLatin1String(noun);
  return translated || count == 1 ? said : said + u's';
}

QString inField(double value, int figures) {
  static const QRegularExpression exponent(QStringLiteral("e\\+?(-?)0*(?=\\d)"));
  return QString::number(value, 'g', figures).replace(exponent, QStringLiteral("e\\1")).replace(u'-', QChar(0x2212));
}

QString inSentence(const std::string& sentence) {
  // Whole ones alone: "wall-3" and "x2" are names.
  static const QRegularExpression number(QStringLiteral("(?<![\\w.-])(-?)(\\d+(?:\\.\\d+)?)(e[+-]?\\d+)?(?!\\w)"));
  QString said = text(sentence);
  for (qsizetype from = 0;;) {
    const QRegularExpressionMatch found = number.match(said, from);
    if (!found.hasMatch()) return said;
    const bool hasPower = found.capturedLength(3) > 0;
    const QString written =
        hasPower ? figure(found.captured().toDouble(), all_figures) : found.captured().replace(u'-', QChar(0x2212));
    said.replace(found.capturedStart(), found.capturedLength(), written);
    from = found.capturedStart() + written.size();
  }
}

QString quantity(double value, const char* unit) {
  const DisplayUnit shown = display_unit(unit, std::abs(value));
  return significant(value * shown.factor) + u' ' + text(shown.name);
}

Scale energyScale(double largest) {
  const std::pair<double, const char*> units[] = {{1e12, "TJ"}, {1e9, "GJ"}, {1e6, "MJ"},
                                                  {1e3, "kJ"},  {1, "J"},    {1e-3, "mJ"}};
  for (const auto& [factor, unit] : units)
    if (largest >= factor) return {factor, QLatin1String(unit)};
  return largest > 0 ? Scale{1e-6, QStringLiteral("µJ")} : Scale{1, QStringLiteral("J")};
}

Scale scaleOf(double largest, const char* unit) {
  const DisplayUnit shown = display_unit(unit, largest);
  return {1 / shown.factor, text(shown.name)};
}

QString orientation(double dip, double dipDirection) {
  return QStringLiteral("%1/%2").arg(std::lround(dip)).arg(std::lround(dipDirection) % 360, 3, 10, QLatin1Char('0'));
}

QString duration(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0) return QStringLiteral("–");
  if (seconds > 0 && seconds < 0.095) return significant(seconds, 2) + QStringLiteral(" s");
  if (seconds < 9.95) return fixed(seconds, 1) + QStringLiteral(" s");
  if (seconds < 59.5) return QStringLiteral("%1 s").arg(std::lround(seconds));
  const long rounded = std::lround(seconds / 5) * 5;
  if (rounded < 3600) {
    const QString minutes = QStringLiteral("%1 min").arg(rounded / 60);
    return rounded % 60 == 0 ? minutes : minutes + QStringLiteral(" %1 s").arg(rounded % 60);
  }
  const long minutes = std::lround(seconds / 60);
  return QStringLiteral("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

bool parse(const QString& text, double& value) {
  QString plain = text.trimmed();
  plain.remove(QChar(0x2009)).remove(u' ').replace(QChar(0x2212), u'-').replace(u',', u'.');
  bool good = false;
  const double parsed = plain.toDouble(&good);
  if (good && std::isfinite(parsed)) value = parsed;
  return good && std::isfinite(parsed);
}

}  // namespace talus::numbers
