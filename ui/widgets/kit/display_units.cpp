#include "widgets/kit/display_units.hpp"

#include <QCoreApplication>
#include <QObject>
#include <QPointer>
#include <QSettings>

namespace talus::units {

namespace {

/// What the project keeps, and what is shown of it where nothing was chosen.
struct Kept {
  const char *quantity, *unit, *usual;
};
constexpr Kept kept_units[] = {{"length", "m", "m"},
                               {"force", "N", "kN"},
                               {"stress", "Pa", "MPa"},
                               {"density", "kg/m³", "kg/m³"},
                               {"angle", "°", "°"}};

QString key(const QString& quantity) { return QStringLiteral("units/") + quantity; }

}  // namespace

const std::vector<Choice>& choices() {
  const auto unit = [](const char* name) { return QString::fromUtf8(name); };
  static const std::vector<Choice> all{
      {QStringLiteral("length"), QObject::tr("Length"), {QString(), unit("m"), unit("cm"), unit("mm"), unit("ft")}},
      {QStringLiteral("force"), QObject::tr("Force"), {QString(), unit("N"), unit("kN"), unit("MN")}},
      {QStringLiteral("stress"), QObject::tr("Stress"), {QString(), unit("Pa"), unit("kPa"), unit("MPa"), unit("GPa")}},
      {QStringLiteral("density"), QObject::tr("Density"), {QString(), unit("kg/m³"), unit("t/m³"), unit("kN/m³")}},
      {QStringLiteral("angle"), QObject::tr("Angle"), {QString(), unit("°"), unit("rad")}}};
  return all;
}

QString chosen(const QString& quantity) {
  // Kept, since to open the settings takes longer than to build a field, which asks for five.
  static QPointer<QSettings> settings;
  if (!settings) settings = new QSettings(qApp);
  return settings->value(key(quantity)).toString();
}

void choose(const QString& quantity, const QString& unit) { QSettings().setValue(key(quantity), unit); }

QString shown(const QString& kept, const QString& usual) {
  for (const auto& [quantity, unit, ignored] : kept_units) {
    const QString own = QString::fromUtf8(unit);
    const QString other = chosen(QLatin1String(quantity));
    if (other.isEmpty()) continue;
    if (kept == own) return other;
    if (kept == own + QStringLiteral("/m") && own != QLatin1String("m")) return other + QStringLiteral("/m");
  }
  return usual.isEmpty() ? kept : usual;
}

QString summary() {
  QStringList names;
  for (const auto& [quantity, unit, usual] : kept_units)
    if (quantity != QLatin1String("density") || !chosen(QLatin1String(quantity)).isEmpty())
      names << shown(QString::fromUtf8(unit), QString::fromUtf8(usual));
  return names.join(QStringLiteral(" · "));
}

}  // namespace talus::units
